// Tables of words and numbers as text: aligned columns for people, Markdown for documents.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace warplut {

// Rows may be shorter than the header; missing cells are empty. The first `left` columns are
// aligned left, the others right.
struct TextTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::size_t left = 1;
};

// Columns two spaces apart, each line ended by a newline, without trailing spaces.
std::string ToText(const TextTable& table);

// A Markdown table; '|' in cells is escaped.
std::string ToMarkdown(const TextTable& table);

}  // namespace warplut
