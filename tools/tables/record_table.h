// Tables that are declared once: a column has the key that programs read, the heading that people
// read, and one function that gives both of them their value.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/tables/table_text.h"

namespace warplut {

using Json = nlohmann::ordered_json;

// One value: as programs and as people read it.
struct Cell {
  Json value;
  std::string text;
};

Cell TextCell(std::string text);

// `digits` behind the point. A value that is not finite is null and "-".
Cell NumberCell(double value, int digits);

// A change: the same with its sign; "0" where it rounds to 0.
Cell SignedCell(double value, int digits);

// A PSNR in dB with two digits. Equal images have no finite one: null and "equal".
Cell PsnrCell(double psnr);

// A JSON number, or null where `value` is not finite.
Json FiniteJson(double value);

// Where both have a name, the column is in both forms.
template <class Record>
struct Column {
  const char* key;      // of programs; empty: for people alone
  const char* heading;  // of people; empty: for programs alone
  Cell (*cell)(const Record& record);
};

template <class Record>
using Columns = std::vector<Column<Record>>;

// The object of one record: its keys in the order of the columns.
template <class Record>
Json RecordJson(const Columns<Record>& columns, const Record& record) {
  Json json = Json::object();
  for (const Column<Record>& column : columns) {
    if (*column.key != '\0') json[column.key] = column.cell(record).value;
  }
  return json;
}

// The list of the records' objects.
template <class Record>
Json RecordsJson(const Columns<Record>& columns, const std::vector<Record>& records) {
  Json list = Json::array();
  for (const Record& record : records) list.push_back(RecordJson(columns, record));
  return list;
}

// One row for people: the texts of the columns that have a heading.
template <class Record>
std::vector<std::string> RecordRow(const Columns<Record>& columns, const Record& record) {
  std::vector<std::string> row;
  for (const Column<Record>& column : columns) {
    if (*column.heading != '\0') row.push_back(column.cell(record).text);
  }
  return row;
}

// The headings, without rows.
template <class Record>
TextTable RecordHeader(const Columns<Record>& columns) {
  TextTable table;
  for (const Column<Record>& column : columns) {
    if (*column.heading != '\0') table.header.emplace_back(column.heading);
  }
  return table;
}

// A row for each record.
template <class Record>
TextTable RecordTable(const Columns<Record>& columns, const std::vector<Record>& records) {
  TextTable table = RecordHeader(columns);
  for (const Record& record : records) table.rows.push_back(RecordRow(columns, record));
  return table;
}

}  // namespace warplut
