#include "app/serve/request.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/json/text.h"
#include "core/json/value_text.h"

namespace underact::serve {
namespace {

constexpr std::size_t kMostProblems = 100;  // in one answer
constexpr std::size_t kLongestId = 200;     // bytes

/// A step of a JSON pointer: RFC 6901.
std::string stepOf(std::string_view key) {
  std::string step;
  for (const char one : key) step += one == '~' ? "~0" : one == '/' ? "~1" : std::string(1, one);
  return step;
}

void judge(const json::Value& value, const std::string& path, Problems& problems) {
  if (problems.size() >= kMostProblems) return;
  const auto add = [&](const std::string& where, const std::string& sentence) {
    problems.push_back({sentence, {{}, value.line, value.column, where}});
  };
  if (value.kind == json::Kind::Null) add(path, "null is never a value. Omit the key.");
  if (value.kind == json::Kind::Number && !std::isfinite(value.number)) add(path, "This number is too large.");
  std::set<std::string> seen;
  for (std::size_t index = 0; index < value.items.size(); ++index) {
    const bool is_object = value.kind == json::Kind::Object;
    const std::string where = path + "/" + (is_object ? stepOf(value.keys[index]) : std::to_string(index));
    if (is_object && !seen.insert(value.keys[index]).second) add(where, "This key appears twice. Remove one of them.");
    judge(value.items[index], where, problems);
  }
}

bool isScalar(const json::Value& value) {
  return value.kind == json::Kind::String || value.kind == json::Kind::Bool ||
         (value.kind == json::Kind::Number && std::isfinite(value.number));
}

}  // namespace

Result<Request> readRequest(std::string_view text) {
  Result<json::Value> root = json::parse(text, {});
  if (!root) return problemAt("", "This frame is not JSON: " + root.problems().front().sentence);
  if (root.value().kind != json::Kind::Object)
    return problemAt("", "A request is an object, as in {\"id\": 1, \"do\": \"status\"}.");
  const json::Value* const what = root.value().find("do");
  if (what == nullptr) return problemAt("/do", "The key \"do\" is missing: it names the request.");
  Request request;
  const json::Value* const id = root.value().find("id");
  if (id != nullptr && isScalar(*id) && id->text.size() <= kLongestId) request.id = json::textOf(*id);
  if (what->kind == json::Kind::String) request.what = what->text;
  request.root = std::move(root).value();
  return request;
}

Problems generalProblems(const Request& request) {
  Problems problems;
  judge(request.root, "", problems);
  if (request.root.find("id") == nullptr) {
    problems.push_back({"The key \"id\" is missing: the answer carries it.", {{}, 0, 0, "/id"}});
  } else if (request.id == "null" && problems.empty()) {
    problems.push_back({"The id must be a number, true, false, or text of at most 200 bytes.", {{}, 0, 0, "/id"}});
  }
  return problems;
}

Keys::Keys(const Request& request)
    : findings_(std::string()), reader_(request.root, "", "\"" + request.what + "\"", findings_) {
  reader_.find("id");
  reader_.find("do");
}

std::optional<std::string> Keys::text(const char* key, std::size_t longest, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr || !json::isKind(*value, json::Kind::String, key, json::kindName(json::Kind::String), findings_))
    return std::nullopt;
  if (value->text.size() <= longest) return value->text;
  findings_.add(*value, key,
                "This must be at most " + std::to_string(longest) + " bytes; here it is " +
                    std::to_string(value->text.size()) + ".");
  return std::nullopt;
}

std::optional<double> Keys::number(const char* key, double least, double most, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr || !json::isKind(*value, json::Kind::Number, key, json::kindName(json::Kind::Number), findings_))
    return std::nullopt;
  if (value->number >= least && value->number <= most) return value->number;
  findings_.add(*value, key,
                "This must be from " + json::numberText(least) + " to " + json::numberText(most) + "; here it is " +
                    json::numberText(value->number) + ".");
  return std::nullopt;
}

std::optional<bool> Keys::flag(const char* key, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr || !json::isKind(*value, json::Kind::Bool, key, json::kindName(json::Kind::Bool), findings_))
    return std::nullopt;
  return value->boolean;
}

const json::Value* Keys::list(const char* key) {
  const json::Value* const value = reader_.find(key, true);
  if (value == nullptr || !json::isKind(*value, json::Kind::Array, key, json::kindName(json::Kind::Array), findings_))
    return nullptr;
  return value;
}

const json::Value* Keys::object(const char* key, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr || !json::isKind(*value, json::Kind::Object, key, json::kindName(json::Kind::Object), findings_))
    return nullptr;
  return value;
}

void Keys::add(const json::Value& value, const std::string& key, const std::string& sentence) {
  findings_.add(value, key, sentence);
}

bool Keys::areGood() {
  reader_.finish();
  problems_ = findings_.take();
  return problems_.empty();
}

std::string pointerOf(const std::string& key) {
  if (key.empty() || key.front() == '/') return key;
  std::string pointer = "/";
  for (const char one : key) {
    if (one == '.' || one == '[')
      pointer += '/';
    else if (one != ']')
      pointer += one;
  }
  return pointer;
}

Problems below(const std::string& root, const Problems& problems) {
  Problems moved = problems;
  for (Problem& problem : moved) problem.place.key = root + pointerOf(problem.place.key);
  return moved;
}

json::ObjectText wellAnswer(const std::string& id) {
  json::ObjectText answer;
  answer.addJson("id", id);
  answer.addBool("ok", true);
  return answer;
}

std::string problemAnswer(const std::string& id, const Problems& problems) {
  std::vector<json::ObjectText> list;
  for (const Problem& problem : problems) {
    if (list.size() >= kMostProblems) break;
    json::ObjectText object;
    object.addText("path", pointerOf(problem.place.key));
    object.addText("sentence", problem.sentence);
    list.push_back(object);
  }
  json::ObjectText answer;
  answer.addJson("id", id);
  answer.addBool("ok", false);
  answer.addList("problems", list);
  return answer.text();
}

Problems problemAt(const std::string& path, const std::string& sentence) {
  return {{sentence, {{}, 0, 0, path}}};
}

}  // namespace underact::serve
