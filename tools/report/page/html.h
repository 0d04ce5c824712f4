// Pieces of HTML and XML, well-formed by construction.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace warplut {

// Text as it may stand in an element or in a quoted attribute: & < > " ' become entities, control
// characters other than tab and line feed, which no document may have, are left out. UTF-8 passes.
std::string EscapeHtml(std::string_view text);

struct HtmlAttribute {
  std::string_view name;
  std::string_view value;  // escaped by Element
};

// <name attribute="value">content</name>; `content` is HTML already.
std::string Element(std::string_view name, std::initializer_list<HtmlAttribute> attributes,
                    std::string_view content);

// <name attribute="value">, one of the elements that have no content and no end: img, input, meta,
// source.
std::string VoidElement(std::string_view name, std::initializer_list<HtmlAttribute> attributes);

// "data:TYPE;base64,..."
std::string DataUri(std::string_view type, std::string_view bytes);

}  // namespace warplut
