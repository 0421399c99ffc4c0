#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

namespace underact::cli {

/// A table of results: named columns, and rows whose fields are texts, numbers, booleans, or empty. As CSV numbers read
/// back to the same double.
class Table {
 public:
  using Field = std::variant<std::monostate, std::string, double, std::int64_t, bool>;

  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  void add(std::vector<Field> row) { rows_.push_back(std::move(row)); }
  bool isEmpty() const { return rows_.empty(); }
  const std::vector<std::vector<Field>>& rows() const { return rows_; }

  void printCsv(std::ostream& out) const;
  void printJson(std::ostream& out) const;  // one object per line
  void printText(std::ostream& out) const;  // in columns, numbers to four digits

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<Field>> rows_;
};

}  // namespace underact::cli
