#include "app/serve/request.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/json/text.h"
#include "core/json/value_text.h"

namespace underact::serve {
namespace {

constexpr std::size_t kLongestId = 200;    // bytes
constexpr std::size_t kLongestStep = 200;  // of a path, bytes: a frame may be one long key
constexpr std::size_t kMaxKeys = 50;       // of the request itself
constexpr std::size_t kGlanced = 4096;

/// A step of a JSON pointer: RFC 6901.
std::string stepOf(std::string_view key) {
  std::string step;
  for (std::size_t at = 0; at < key.size();) {
    const std::size_t length = std::max<std::size_t>(1, json::codePointLength(key, at));
    if (at + length > kLongestStep) return step + "…";
    step += key[at] == '~' ? "~0" : key[at] == '/' ? "~1" : std::string(key.substr(at, length));
    at += length;
  }
  return step;
}

/// A value, and the way to it: only a problem makes a text of it.
struct Trail {
  const Trail* before = nullptr;
  const json::Value* in = nullptr;
  std::size_t index = 0;

  std::string text() const {
    if (in == nullptr) return {};
    return before->text() + "/" +
           (in->kind == json::JsonKind::Object ? stepOf(in->keys[index]) : std::to_string(index));
  }
};

/// id: of the request, which no double has to hold.
void judge(const json::Value& value, const Trail& trail, const json::Value* id, Problems& problems) {
  const auto add = [&](const Trail& where, const std::string& sentence) {
    if (problems.size() < kMaxProblems) problems.push_back({sentence, {{}, value.line, value.column, where.text()}});
  };
  if (value.kind == json::JsonKind::Null) add(trail, "null is never a value. Omit the key.");
  if (value.kind == json::JsonKind::Number && !std::isfinite(value.number) && &value != id)
    add(trail, "This number is too large.");
  std::unordered_set<std::string_view> seen;
  for (std::size_t index = 0; index < value.items.size() && problems.size() < kMaxProblems; ++index) {
    const Trail step{&trail, &value, index};
    if (value.kind == json::JsonKind::Object && !seen.insert(value.keys[index]).second)
      add(step, "This key appears twice. Remove one of them.");
    judge(value.items[index], step, id, problems);
  }
}

/// An id as JSON, a number with its own digits; none: it is not one.
std::optional<std::string> idText(const json::Value* value) {
  const auto is = [&](json::JsonKind kind) { return value != nullptr && value->kind == kind; };
  const bool is_number = is(json::JsonKind::Number);
  const bool is_scalar = is_number || is(json::JsonKind::String) || is(json::JsonKind::Bool);
  if (!is_scalar || value->text.size() > kLongestId) return std::nullopt;
  return is_number ? value->text : json::textOf(*value);
}

}  // namespace

Glance glanceAt(std::string_view text) {
  text = text.substr(0, kGlanced);
  std::string_view key;
  std::optional<std::string_view> id, what;
  bool is_value = false;  // of the key
  for (std::size_t at = 0, end = 0, depth = 0; at < text.size(); at = end) {
    const char first = text[at];
    end = at + 1;
    if (first == '"') {
      while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
      ++end;
    } else if (first == '-' || std::isalnum(static_cast<unsigned char>(first)) != 0) {
      end = text.find_first_of(",:]} \t\r\n", at);
    }
    if (end > text.size()) break;  // it goes on
    if (first == '{' || first == '[') ++depth;
    if ((first == '}' || first == ']') && depth > 0) --depth;
    if (depth != 1) continue;
    if (first == ':' || first == ',') is_value = first == ':';
    if (end - at < 2 && std::isalnum(static_cast<unsigned char>(first)) == 0) continue;
    const std::string_view token = text.substr(at, end - at);
    if (!is_value) key = token;
    if (is_value && key == "\"id\"" && !id) id = token;
    if (is_value && key == "\"do\"" && !what) what = token;
  }
  Glance glance;
  const auto take = [](const std::optional<std::string_view>& token) {
    return token && token->size() <= 2 * kLongestId ? json::parse(*token, {}) : Result<json::Value>(Problems{});
  };
  if (const Result<json::Value> value = take(id); value) glance.id = idText(&value.value()).value_or(glance.id);
  if (const Result<json::Value> value = take(what); value) glance.what = value.value().text;
  return glance;
}

Result<Request> readRequest(std::string_view text) {
  Result<json::Value> root = json::parse(text, {});
  if (!root) return problemAt("", "This frame is not JSON: " + root.problems().front().sentence);
  if (root.value().kind != json::JsonKind::Object)
    return problemAt("", "A request is an object, as in {\"id\": 1, \"do\": \"status\"}.");
  const json::Value* const what = root.value().find("do");
  if (what == nullptr) return problemAt("/do", "The key \"do\" is missing: it names the request.");
  Request request;
  request.id = idText(root.value().find("id")).value_or(request.id);
  if (what->kind == json::JsonKind::String) request.what = what->text;
  request.read = std::make_shared<const json::Value>(std::move(root).value());
  return request;
}

Problems generalProblems(const Request& request) {
  if (request.root().keys.size() > kMaxKeys)
    return problemAt("", "A request has at most " + std::to_string(kMaxKeys) + " keys.");
  Problems problems;
  const json::Value* const id = request.root().find("id");
  judge(request.root(), {}, id, problems);
  if (id == nullptr) {
    problems.push_back({"The key \"id\" is missing: the answer carries it.", {{}, 0, 0, "/id"}});
  } else if (request.id == "null" && problems.empty()) {
    problems.push_back({"The id must be a number, true, false, or text, of at most 200 bytes.", {{}, 0, 0, "/id"}});
  }
  return problems;
}

Keys::Keys(const Request& request)
    : findings_(std::string()), reader_(request.root(), "", "\"" + request.what + "\"", findings_) {
  reader_.find("id");
  reader_.find("do");
}

std::optional<std::string> Keys::text(const char* key, std::size_t longest, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr ||
      !json::isKind(*value, json::JsonKind::String, key, json::kindName(json::JsonKind::String), findings_))
    return std::nullopt;
  if (value->text.size() <= longest) return value->text;
  findings_.add(*value, key,
                "This must be at most " + std::to_string(longest) + " bytes; here it is " +
                    std::to_string(value->text.size()) + ".");
  return std::nullopt;
}

std::optional<double> Keys::number(const char* key, double min, double max, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr ||
      !json::isKind(*value, json::JsonKind::Number, key, json::kindName(json::JsonKind::Number), findings_))
    return std::nullopt;
  if (value->number >= min && value->number <= max) return value->number;
  findings_.add(*value, key,
                "This must be from " + json::numberText(min) + " to " + json::numberText(max) + "; here it is " +
                    json::numberText(value->number) + ".");
  return std::nullopt;
}

std::optional<bool> Keys::flag(const char* key, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr ||
      !json::isKind(*value, json::JsonKind::Bool, key, json::kindName(json::JsonKind::Bool), findings_))
    return std::nullopt;
  return value->boolean;
}

const json::Value* Keys::list(const char* key) {
  const json::Value* const value = reader_.find(key, true);
  if (value == nullptr ||
      !json::isKind(*value, json::JsonKind::Array, key, json::kindName(json::JsonKind::Array), findings_))
    return nullptr;
  return value;
}

const json::Value* Keys::object(const char* key, bool required) {
  const json::Value* const value = reader_.find(key, required);
  if (value == nullptr ||
      !json::isKind(*value, json::JsonKind::Object, key, json::kindName(json::JsonKind::Object), findings_))
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

json::ObjectText okAnswer(const std::string& id) {
  json::ObjectText answer;
  answer.addJson("id", id);
  answer.addBool("ok", true);
  return answer;
}

std::string problemAnswer(const std::string& id, const Problems& problems) {
  std::vector<json::ObjectText> list;
  for (const Problem& problem : problems) {
    if (list.size() >= kMaxProblems) break;
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
