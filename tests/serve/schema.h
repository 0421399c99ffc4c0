#pragma once
#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <string>

namespace underact::test {

/// A part of the schema that the guide has for the wire: "request", "answer" or "push".
class Schema {
 public:
  explicit Schema(const std::string& part) {
    std::ifstream file(std::string(UNDERACT_SOURCE) + "/resources/guide/live_service.schema.json");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    whole_.Parse(text.c_str());
    rapidjson::Value list(rapidjson::kArrayType), reference(rapidjson::kObjectType);
    const std::string target = "#/definitions/" + part;
    reference.AddMember("$ref", rapidjson::Value(target.c_str(), whole_.GetAllocator()), whole_.GetAllocator());
    list.PushBack(reference, whole_.GetAllocator());
    whole_.RemoveMember("anyOf");
    whole_.AddMember("allOf", list, whole_.GetAllocator());
    schema_ = std::make_unique<rapidjson::SchemaDocument>(whole_);
  }
  bool accepts(const std::string& text) const {
    rapidjson::Document message;
    message.Parse(text.c_str(), text.size());
    if (message.HasParseError()) return false;
    rapidjson::SchemaValidator validator(*schema_);
    return message.Accept(validator);
  }

 private:
  rapidjson::Document whole_;
  std::unique_ptr<rapidjson::SchemaDocument> schema_;
};

}  // namespace underact::test
