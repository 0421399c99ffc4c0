#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/json/json.h"
#include "core/json/object_reader.h"
#include "core/json/object_text.h"
#include "core/scene/description.h"

namespace underact::serve {

inline constexpr std::size_t kMaxProblems = 100;   // in one answer
inline constexpr std::size_t kMaxHints = 10;       // of them, how many say which word is near: to look for it is slow
inline constexpr std::size_t kMaxSettings = 5000;  // in a request: more than a scene has

/// A request as it came: an object with "do".
struct Request {
  const json::Value& root() const { return *read; }

  std::string id = "null";  // as JSON; null: it has none, or none that an answer can carry
  std::string what;         // of "do"
  std::shared_ptr<const json::Value> read = {};
  std::uint64_t stops = 0;   // as in Frame
  bool has_stopped = false;  // likewise

  // What a worker has found out already, of a long one.
  std::optional<Problems> general = {};                   // generalProblems()
  std::uint64_t revision = 0;                             // of the scene that these belong to:
  std::optional<Result<scene::Description>> edited = {};  // by set
  std::optional<Result<std::string>> values = {};         // of get
};

/// What the first bytes of a frame say, without reading it: the id, as JSON, and the name of the request.
struct Glance {
  std::string id = "null", what;
};
/// Looks at 4096 bytes at most, and at nothing within lists and objects. What does not stand there is empty, or null.
Glance glanceAt(std::string_view text);

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
  std::optional<double> number(const char* key, double min, double max, bool required = true);
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

/// The problems with pointers below `root`: "/scene".
Problems below(const std::string& root, const Problems& problems);

/// {"id": ..., "ok": true} to add results to.
json::ObjectText okAnswer(const std::string& id);

/// {"id": ..., "ok": false, "problems": [{"path": ..., "sentence": ...}]}
std::string problemAnswer(const std::string& id, const Problems& problems);

/// One problem.
Problems problemAt(const std::string& path, const std::string& sentence);

}  // namespace underact::serve
