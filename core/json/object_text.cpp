#include "core/json/object_text.h"

#include "core/json/json.h"

namespace underact::json {
namespace {

template <class List, class Text>
std::string listOf(const List& values, Text text) {
  std::string list;
  for (const auto& value : values) list += (list.empty() ? "" : ", ") + text(value);
  return "[" + list + "]";
}

}  // namespace

void ObjectText::addText(std::string_view key, std::string_view value) {
  addRaw(key, quotedText(value));
}

void ObjectText::addNumber(std::string_view key, double value) {
  addRaw(key, numberText(value));
}

void ObjectText::addVector(std::string_view key, const Vec3& value) {
  addList(key, std::span(value.data(), 3));
}

void ObjectText::addList(std::string_view key, std::span<const double> values) {
  addRaw(key, listOf(values, numberText));
}

void ObjectText::addTexts(std::string_view key, const std::vector<std::string>& values) {
  addRaw(key, listOf(values, quotedText));
}

void ObjectText::addMatrix(std::string_view key, const Eigen::MatrixXd& value) {
  std::vector<Eigen::RowVectorXd> rows;
  for (Eigen::Index row = 0; row < value.rows(); ++row) rows.emplace_back(value.row(row));
  addRaw(key, listOf(rows, [](const Eigen::RowVectorXd& row) {
           return listOf(std::span(row.data(), static_cast<std::size_t>(row.size())), numberText);
         }));
}

void ObjectText::addList(std::string_view key, const std::vector<ObjectText>& values) {
  addRaw(key, listOf(values, [](const ObjectText& value) { return value.text(); }));
}

void ObjectText::addAll(const ObjectText& other) {
  if (!members_.empty() && !other.members_.empty()) members_ += ", ";
  members_ += other.members_;
}

void ObjectText::addRaw(std::string_view key, const std::string& json) {
  if (!members_.empty()) members_ += ", ";
  members_ += quotedText(key) + ": " + json;
}

}  // namespace underact::json
