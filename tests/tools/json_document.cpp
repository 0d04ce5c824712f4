#include "tests/tools/json_document.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace warplut {
namespace {

using Path = std::vector<std::string>;

// "a.b[]" is {"a", "b", "[]"}.
Path PathOf(const std::string& text) {
  Path path;
  std::istringstream names(text);
  for (std::string name; std::getline(names, name, '.');) {
    const bool list = name.ends_with("[]");
    if (list) name.resize(name.size() - 2);
    if (!name.empty()) path.push_back(name);
    if (list) path.emplace_back("[]");
  }
  return path;
}

std::string Text(const Path& path) {
  std::string text;
  for (const std::string& name : path) {
    text += name == "[]" || text.empty() ? name : "." + name;
  }
  return text.empty() ? "the document" : text;
}

// The paths between back quotes.
std::vector<Path> QuotedPaths(const std::string& text) {
  std::vector<Path> paths;
  std::istringstream parts(text);
  std::string part;
  for (bool quoted = false; std::getline(parts, part, '`'); quoted = !quoted) {
    if (quoted) paths.push_back(PathOf(part));
  }
  return paths;
}

std::vector<std::string> Cells(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream parts(row.substr(1));
  for (std::string cell; std::getline(parts, cell, '|');) {
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
    cells.push_back(cell);
  }
  return cells;
}

std::vector<std::string> TypesOf(std::string cell) {
  std::vector<std::string> types;
  for (std::size_t at; (at = cell.find(" or ")) != std::string::npos; cell.erase(0, at + 4)) {
    types.push_back(cell.substr(0, at));
  }
  types.push_back(cell);
  return types;
}

// Whether `path` is the beginning of the key's, or all of it.
bool Begins(const Path& path, const Path& key) {
  return path.size() <= key.size() &&
         std::equal(path.begin(), path.end(), key.begin(),
                    [](const std::string& a, const std::string& b) { return a == b || b == "*"; });
}

bool Is(const Path& path, const Path& key) {
  return path.size() == key.size() && Begins(path, key);
}

std::string TypeOf(const nlohmann::json& value) {
  return value.is_array() ? "list" : value.is_number() ? "number" : value.type_name();
}

class Comparison {
 public:
  explicit Comparison(const std::vector<DocumentedKey>& keys) : keys_(keys) {}

  void Compare(const nlohmann::json& value, const Path& path) {
    const bool goes_on = std::any_of(keys_.begin(), keys_.end(), [&](const DocumentedKey& key) {
      return Begins(path, key.path) && key.path.size() > path.size();
    });
    const DocumentedKey* documented = nullptr;
    for (const DocumentedKey& key : keys_) {
      if (Is(path, key.path)) documented = &key;
    }
    if (documented != nullptr) {
      const std::vector<std::string>& types = documented->types;
      if (std::find(types.begin(), types.end(), TypeOf(value)) == types.end()) {
        Fault(Text(path) + " is of type " + TypeOf(value) + "; documented: " + types.front());
      }
    } else if (!goes_on) {
      Fault(Text(path) + " is not documented");
    }
    if (goes_on) Descend(value, path);
  }

  std::vector<std::string> Faults() const { return {faults_.begin(), faults_.end()}; }

 private:
  void Fault(const std::string& sentence) { faults_.insert(sentence); }

  void Descend(const nlohmann::json& value, const Path& path) {
    Path below = path;
    below.emplace_back("[]");
    if (value.is_array()) {
      for (const nlohmann::json& element : value) Compare(element, below);
    }
    if (!value.is_object()) return;
    for (const auto& [name, member] : value.items()) {
      below.back() = name;
      Compare(member, below);
    }
    for (const DocumentedKey& key : keys_) {
      if (!key.required || key.path.size() <= path.size() || !Begins(path, key.path)) continue;
      const std::string& name = key.path[path.size()];
      if (name != "*" && !value.contains(name)) Fault(Text(path) + " has no " + name);
    }
  }

  const std::vector<DocumentedKey>& keys_;
  std::set<std::string> faults_;
};

}  // namespace

std::vector<DocumentedKey> DocumentedKeys(const std::string& page, const std::string& command) {
  std::vector<DocumentedKey> keys;
  std::vector<Path> owners = {{}};
  int document = 0;
  bool inside = false;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) {
      inside = line == "## " + command;
      owners = {{}};
    } else if (inside && line.starts_with("Below ")) {
      owners = QuotedPaths(line);
    } else if (inside && line.starts_with("The document ")) {
      owners = {{}};
      ++document;
    } else if (inside && line.starts_with("| `")) {
      const std::vector<std::string> cells = Cells(line);
      for (const Path& owner : owners) {
        for (const Path& path : QuotedPaths(cells.at(0))) {
          DocumentedKey& key = keys.emplace_back(owner, TypesOf(cells.at(1)));
          key.path.insert(key.path.end(), path.begin(), path.end());
          key.required = !cells.at(2).starts_with("if ");
          key.document = document;
        }
      }
    }
  }
  return keys;
}

std::vector<std::string> JsonFaults(const nlohmann::json& document,
                                    const std::vector<DocumentedKey>& keys) {
  std::optional<std::vector<std::string>> fewest;
  const int last = keys.empty() ? 0 : keys.back().document;
  for (int i = std::min(last, 1); i <= last; ++i) {
    std::vector<DocumentedKey> of_document;
    std::copy_if(keys.begin(), keys.end(), std::back_inserter(of_document),
                 [i](const DocumentedKey& key) { return key.document == i; });
    Comparison comparison(of_document);
    comparison.Compare(document, {});
    std::vector<std::string> faults = comparison.Faults();
    if (!fewest || faults.size() < fewest->size()) fewest = std::move(faults);
  }
  return *fewest;
}

std::string JsonSection(const std::vector<std::string>& arguments) {
  const std::string& command = arguments.at(0);
  if (command == "dataset" || command == "bench") return command + " " + arguments.at(1);
  const bool judges =
      std::find(arguments.begin(), arguments.end(), "--sequence") != arguments.end();
  return command == "eval" && judges ? "judge" : command;
}

}  // namespace warplut
