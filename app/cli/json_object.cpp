#include "app/cli/json_object.h"

#include "core/json/json.h"

namespace underact::cli {
namespace {

template <class List, class Text>
std::string listOf(const List& values, Text text) {
  std::string list;
  for (const auto& value : values) list += (list.empty() ? "" : ", ") + text(value);
  return "[" + list + "]";
}

}  // namespace

void JsonObject::addText(std::string_view key, std::string_view value) {
  addRaw(key, json::quotedText(value));
}

void JsonObject::addNumber(std::string_view key, double value) {
  addRaw(key, json::numberText(value));
}

void JsonObject::addVector(std::string_view key, const Vec3& value) {
  addList(key, std::span(value.data(), 3));
}

void JsonObject::addList(std::string_view key, std::span<const double> values) {
  addRaw(key, listOf(values, json::numberText));
}

void JsonObject::addTexts(std::string_view key, const std::vector<std::string>& values) {
  addRaw(key, listOf(values, json::quotedText));
}

void JsonObject::addMatrix(std::string_view key, const Eigen::MatrixXd& value) {
  std::vector<Eigen::RowVectorXd> rows;
  for (Eigen::Index row = 0; row < value.rows(); ++row) rows.emplace_back(value.row(row));
  addRaw(key, listOf(rows, [](const Eigen::RowVectorXd& row) {
           return listOf(std::span(row.data(), static_cast<std::size_t>(row.size())), json::numberText);
         }));
}

void JsonObject::addList(std::string_view key, const std::vector<JsonObject>& values) {
  addRaw(key, listOf(values, [](const JsonObject& value) { return value.text(); }));
}

void JsonObject::addRaw(std::string_view key, const std::string& json) {
  if (!members_.empty()) members_ += ", ";
  members_ += json::quotedText(key) + ": " + json;
}

}  // namespace underact::cli
