#include "tests/serve/schema.h"

#include <rapidjson/document.h>
#include <rapidjson/schema.h>

#include <fstream>
#include <iterator>

namespace underact::test {
namespace {

rapidjson::Document wholeSchema() {
  std::ifstream file(std::string(UNDERACT_SOURCE) + "/resources/guide/live_service.schema.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  rapidjson::Document whole;
  whole.Parse(text.c_str());
  return whole;
}

}  // namespace

struct Schema::Parts {
  rapidjson::Document whole;
  std::unique_ptr<rapidjson::SchemaDocument> part;
};

Schema::Schema(const std::string& part) : parts_(std::make_unique<Parts>()) {
  rapidjson::Document& whole = parts_->whole = wholeSchema();
  rapidjson::Value list(rapidjson::kArrayType), reference(rapidjson::kObjectType);
  const std::string target = "#/definitions/" + part;
  reference.AddMember("$ref", rapidjson::Value(target.c_str(), whole.GetAllocator()), whole.GetAllocator());
  list.PushBack(reference, whole.GetAllocator());
  whole.RemoveMember("anyOf");
  whole.AddMember("allOf", list, whole.GetAllocator());
  parts_->part = std::make_unique<rapidjson::SchemaDocument>(whole);
}

Schema::~Schema() = default;

bool Schema::accepts(const std::string& text) const {
  rapidjson::Document message;
  message.Parse(text.c_str(), text.size());
  if (message.HasParseError()) return false;
  rapidjson::SchemaValidator validator(*parts_->part);
  return message.Accept(validator);
}

}  // namespace underact::test
