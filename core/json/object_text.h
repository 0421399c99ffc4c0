#pragma once
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/types.h"

namespace underact::json {

/// The text of a JSON object on one line, its members in the order in which they are added.
class ObjectText {
 public:
  void addText(std::string_view key, std::string_view value);  // any text of UTF-8; no key twice
  void addNumber(std::string_view key, double value);          // null if it is not finite
  void addInteger(std::string_view key, std::integral auto value) { addRaw(key, std::to_string(value)); }  // all digits
  void addBool(std::string_view key, bool value) { addRaw(key, value ? "true" : "false"); }  // true, false
  void addNull(std::string_view key) { addRaw(key, "null"); }                                // no value
  void addVector(std::string_view key, const Vec3& value);                                   // a list of three numbers
  void addList(std::string_view key, std::span<const double> values);                        // of numbers
  void addTexts(std::string_view key, const std::vector<std::string>& values);               // a list
  void addMatrix(std::string_view key, const Eigen::MatrixXd& value);                        // a list of rows
  void addObject(std::string_view key, const ObjectText& value) { addRaw(key, value.text()); }  // one
  void addList(std::string_view key, const std::vector<ObjectText>& values);                    // of objects
  void addJson(std::string_view key, const std::string& json) { addRaw(key, json); }  // a value as it stands in a file
  /// Adds the members of another object behind its own.
  void addAll(const ObjectText& other);
  std::string text() const { return "{" + members_ + "}"; }  // the object as it is now

 private:
  void addRaw(std::string_view key, const std::string& json);
  std::string members_;
};

}  // namespace underact::json
