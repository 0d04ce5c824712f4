#include "datasets/sequence/frame_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace warplut {
namespace {

// A conversion %d, %Nd or %0Nd that begins at `begin` and ends before `end`.
struct Conversion {
  std::size_t begin = 0, end = 0;
  int width = 0;
  char fill = ' ';
};

std::optional<Conversion> ConversionAt(std::string_view pattern, std::size_t begin) {
  Conversion c;
  c.begin = begin;
  std::size_t i = begin + 1;
  if (i < pattern.size() && pattern[i] == '0') {
    c.fill = '0';
    ++i;
  }
  if (i < pattern.size() && pattern[i] >= '1' && pattern[i] <= '9') c.width = pattern[i++] - '0';
  if (c.fill == '0' && c.width == 0) return std::nullopt;
  if (i >= pattern.size() || pattern[i] != 'd') return std::nullopt;
  c.end = i + 1;
  return c;
}

// ".." stands at the beginning alone: behind a link it would not lead back.
bool StaysBelow(std::string_view path, int levels_up) {
  if (path.empty() || path.front() == '/') return false;
  for (; levels_up > 0 && path.starts_with("../"); --levels_up) path.remove_prefix(3);
  while (true) {
    const std::size_t slash = path.find('/');
    const std::string_view part = path.substr(0, slash);
    if (part.empty() || part == "." || part == "..") return false;
    if (slash == std::string_view::npos) return true;
    path.remove_prefix(slash + 1);
  }
}

// Calls text(piece) and conversion(c) in order; false at a '%' that begins neither a conversion nor
// "%%".
template <class Text, class Number>
bool Parse(std::string_view pattern, const Text& text, const Number& conversion) {
  for (std::size_t i = 0; i < pattern.size();) {
    if (pattern[i] != '%') {
      text(pattern[i++]);
    } else if (i + 1 < pattern.size() && pattern[i + 1] == '%') {
      text('%');
      i += 2;
    } else if (const auto c = ConversionAt(pattern, i)) {
      conversion(*c);
      i = c->end;
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace

bool IsFramePattern(std::string_view pattern, std::string* why, int levels_up) {
  const auto no = [&](std::string reason) {
    if (why) *why = std::move(reason);
    return false;
  };
  if (std::any_of(pattern.begin(), pattern.end(), [](char c) {
        return c == '\\' || c == 127 || static_cast<unsigned char>(c) < 32;
      })) {
    return no("has a backslash or a control character; expected '/' between folders");
  }
  if (!StaysBelow(pattern, levels_up)) {
    return no(
        levels_up == 0
            ? "is absolute or has an empty, '.' or '..' part; expected a path below the manifest's "
              "folder, or the option --streams-below"
            : fmt::format("is absolute or has an empty, '.' or '..' part; expected a path with at "
                          "most {} '..', all at its beginning",
                          levels_up));
  }
  int conversions = 0;
  if (!Parse(
          pattern, [](char) {}, [&](const Conversion&) { ++conversions; })) {
    return no("has a '%' that is not %d, %4d, %04d or the like; expected one of these");
  }
  if (conversions != 1) {
    return no(fmt::format("has {} conversions; expected one, as %04d", conversions));
  }
  return true;
}

std::string FrameFileName(std::string_view pattern, int number) {
  std::string name;
  Parse(
      pattern, [&](char c) { name += c; },
      [&](const Conversion& c) {
        const std::string digits = std::to_string(number);
        const std::size_t width = static_cast<std::size_t>(c.width);
        if (digits.size() < width) name.append(width - digits.size(), c.fill);
        name += digits;
      });
  return name;
}

}  // namespace warplut
