#include "tools/report/page/html.h"

#include <cstdint>

namespace warplut {
namespace {

std::string Start(std::string_view name, std::initializer_list<HtmlAttribute> attributes) {
  std::string html = "<";
  html += name;
  for (const HtmlAttribute& attribute : attributes) {
    html += ' ';
    html += attribute.name;
    html += "=\"" + EscapeHtml(attribute.value) + '"';
  }
  return html + '>';
}

// RFC 4648, with padding.
std::string Base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string EscapeHtml(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n') escaped += c;
    }
  }
  return escaped;
}

std::string Element(std::string_view name, std::initializer_list<HtmlAttribute> attributes,
                    std::string_view content) {
  std::string html = Start(name, attributes);
  html += content;
  html += "</";
  html += name;
  return html + '>';
}

std::string VoidElement(std::string_view name, std::initializer_list<HtmlAttribute> attributes) {
  return Start(name, attributes);
}

std::string DataUri(std::string_view type, std::string_view bytes) {
  std::string uri = "data:";
  uri += type;
  uri += ";base64,";
  return uri + Base64(bytes);
}

}  // namespace warplut
