#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/object_text.h"

namespace underact::serve {

/// A request as it came: an object with "do".
struct Request {
  std::string id = "null";  // as JSON; null: it has none, or none that an answer can carry
  std::string what;         // of "do"
  json::Value root;
};

/// Reads a frame. Problems: it is not JSON, or has no "do"; such frames are counted.
Result<Request> readRequest(std::string_view text);

/// What no request may have anywhere: null, a number too large for a double, a key twice, no usable id. Each with its
/// path.
Problems generalProblems(const Request& request);

/// The keys of a request, read one by one; take() has the problems of all of them, unknown keys too, by JSON pointers.
class Keys {
 public:
  explicit Keys(const Request& request);
  const json::Value* find(const char* key, bool required = true) { return reader_.find(key, required); }
  // The value of a key, or none where it is missing or of another kind, which is then a problem.
  std::optional<std::string> text(const char* key, std::size_t longest, bool required = true);
  std::optional<double> number(const char* key, double least, double most, bool required = true);
  std::optional<bool> flag(const char* key, bool required = true);
  const json::Value* list(const char* key);
  const json::Value* object(const char* key, bool required = true);
  void add(const json::Value& value, const std::string& key, const std::string& sentence);
  /// Whether there is no problem; unknown keys are looked for, too. Once.
  bool areGood();
  const Problems& problems() const { return problems_; }

 private:
  json::Findings findings_;
  json::ObjectReader reader_;
  Problems problems_;
};

/// The JSON pointer of a key's path: "constraints[0].radius_mm" is "/constraints/0/radius_mm"; one that is a pointer
/// stays.
std::string pointerOf(const std::string& key);

/// The same problems with pointers below `root`: "/scene".
Problems below(const std::string& root, const Problems& problems);

/// {"id": ..., "ok": true} to add results to.
json::ObjectText wellAnswer(const std::string& id);

/// {"id": ..., "ok": false, "problems": [{"path": ..., "sentence": ...}]}
std::string problemAnswer(const std::string& id, const Problems& problems);

/// One problem.
Problems problemAt(const std::string& path, const std::string& sentence);

}  // namespace underact::serve
