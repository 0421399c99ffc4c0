#include "app/cli/table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "app/cli/json_object.h"
#include "core/base/printed.h"
#include "core/json/json.h"

namespace underact::cli {
namespace {

std::string quotedForCsv(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

struct CsvText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(const std::string& text) const { return quotedForCsv(text); }
  std::string operator()(double number) const { return json::numberText(number); }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
};

struct PlainText {
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(const std::string& text) const { return printed(text); }
  std::string operator()(double number) const {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
  }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
  std::string operator()(bool truth) const { return truth ? "yes" : "no"; }
};

/// Of UTF-8, in characters.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

bool isNumber(const Table::Field& field) {
  return std::holds_alternative<double>(field) || std::holds_alternative<std::int64_t>(field);
}

}  // namespace

void Table::printCsv(std::ostream& out) const {
  for (std::size_t column = 0; column < columns_.size(); ++column) out << (column > 0 ? "," : "") << columns_[column];
  out << '\n';
  for (const std::vector<Field>& row : rows_) {
    for (std::size_t column = 0; column < row.size(); ++column)
      out << (column > 0 ? "," : "") << std::visit(CsvText{}, row[column]);
    out << '\n';
  }
}

void Table::printJson(std::ostream& out) const {
  for (const std::vector<Field>& row : rows_) {
    JsonObject object;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string& key = columns_[column];
      const Field& field = row[column];
      if (std::holds_alternative<std::monostate>(field)) object.addNull(key);
      if (const auto* text = std::get_if<std::string>(&field)) object.addText(key, *text);
      if (const auto* number = std::get_if<double>(&field)) object.addNumber(key, *number);
      if (const auto* number = std::get_if<std::int64_t>(&field)) object.addInteger(key, *number);
      if (const auto* truth = std::get_if<bool>(&field)) object.addBool(key, *truth);
    }
    out << object.text() << '\n';
  }
}

void Table::printText(std::ostream& out) const {
  std::vector<std::vector<std::string>> texts{columns_};
  for (const std::vector<Field>& row : rows_) {
    std::vector<std::string>& line = texts.emplace_back();
    for (const Field& field : row) line.push_back(std::visit(PlainText{}, field));
  }
  for (std::size_t line = 0; line < texts.size(); ++line) {
    for (std::size_t column = 0; column < texts[line].size(); ++column) {
      std::size_t width = 0;
      for (const std::vector<std::string>& other : texts) width = std::max(width, widthOf(other[column]));
      const std::string space(width - widthOf(texts[line][column]), ' ');
      const bool right = !rows_.empty() && isNumber(rows_[line > 0 ? line - 1 : 0][column]);
      out << (column > 0 ? "  " : "") << (right ? space + texts[line][column] : texts[line][column] + space);
    }
    out << '\n';
  }
}

}  // namespace underact::cli
