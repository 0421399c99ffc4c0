#pragma once
#include <memory>
#include <string>

namespace underact::test {

/// A part of the schema that the guide has for the wire: "request", "answer" or "push".
class Schema {
 public:
  explicit Schema(const std::string& part);
  ~Schema();
  bool accepts(const std::string& text) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace underact::test
