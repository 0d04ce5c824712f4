#include "tools/tables/table_text.h"

#include <algorithm>

namespace warplut {
namespace {

const std::string& CellText(const std::vector<std::string>& row, std::size_t column) {
  static const std::string empty;
  return column < row.size() ? row[column] : empty;
}

std::string TextRow(const std::vector<std::string>& row, const std::vector<std::size_t>& widths,
                    std::size_t left) {
  std::string line;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const std::string& cell = CellText(row, column);
    const std::string fill(widths[column] - cell.size(), ' ');
    if (column > 0) line += "  ";
    line += column < left ? cell + fill : fill + cell;
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string MarkdownRow(const std::vector<std::string>& row, std::size_t columns) {
  std::string line = "|";
  for (std::size_t column = 0; column < columns; ++column) {
    line += ' ';
    for (const char c : CellText(row, column)) {
      if (c == '|') line += '\\';
      line += c;
    }
    line += " |";
  }
  return line + "\n";
}

}  // namespace

std::string ToText(const TextTable& table) {
  std::vector<std::size_t> widths(table.header.size());
  for (std::size_t column = 0; column < widths.size(); ++column) {
    widths[column] = table.header[column].size();
    for (const auto& row : table.rows)
      widths[column] = std::max(widths[column], CellText(row, column).size());
  }
  std::string text = TextRow(table.header, widths, table.left);
  for (const auto& row : table.rows) text += TextRow(row, widths, table.left);
  return text;
}

std::string ToMarkdown(const TextTable& table) {
  const std::size_t columns = table.header.size();
  std::string text = MarkdownRow(table.header, columns);
  text += "|";
  for (std::size_t column = 0; column < columns; ++column) {
    text += column < table.left ? "---|" : "---:|";
  }
  text += "\n";
  for (const auto& row : table.rows) text += MarkdownRow(row, columns);
  return text;
}

}  // namespace warplut
