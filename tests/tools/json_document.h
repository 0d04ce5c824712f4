// The JSON that commands print, against docs/JSON.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace warplut {

// One key of a table of the page.
struct DocumentedKey {
  std::vector<std::string> path;   // "a[].b" is {"a", "[]", "b"}; "*" is any name
  std::vector<std::string> types;  // "string", "number", "boolean", "null", "list", "object"
  bool required = true;            // its meaning does not begin with "if"
  int document = 0;                // a command may print one of several documents
};

// The keys of the section "## COMMAND" of a page, in its order; none if there is no such section.
std::vector<DocumentedKey> DocumentedKeys(const std::string& page, const std::string& command);

// One sentence for each key of `document` that `keys` lack or give another type, and for each key
// that a table requires and the document lacks. Of several documents the one that fits best counts.
std::vector<std::string> JsonFaults(const nlohmann::json& document,
                                    const std::vector<DocumentedKey>& keys);

// The section that describes the JSON of a command line: "bench sr", "judge".
std::string JsonSection(const std::vector<std::string>& arguments);

}  // namespace warplut
