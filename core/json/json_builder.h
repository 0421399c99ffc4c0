#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/json/json.h"
#include "core/json/json_source.h"

namespace underact::json {

/// Where reading had to stop, and why, in plain words.
struct Stop {
  std::size_t offset = 0;
  Sentence sentence;
};

/// Builds the values from RapidJSON's events (its names, its order).
class Builder {
 public:
  /// source: the one that RapidJSON reads from, of the same text; both outlive the builder.
  Builder(const Source& source, std::string_view text) : source_(source), places_(text) {}
  /// What was built, moved out; whole only after reading that ended without an error.
  Value takeRoot() { return std::move(root_); }
  /// Why one of the calls below gave false; empty where none did.
  const Stop& refusal() const { return refusal_; }

  // RapidJSON's handler, called in the order of the text. False stops the parse; refusal() says why.
  bool Null() { return add(start(JsonKind::Null, source_.Tell() - 4)); }
  bool Bool(bool value);
  bool Uint(unsigned);  // the lone 0 that Source shows for every number
  bool Int(int) { return false; }
  bool Int64(std::int64_t) { return false; }
  bool Uint64(std::uint64_t) { return false; }
  bool Double(double) { return false; }
  bool RawNumber(const char*, unsigned, bool) { return false; }
  bool String(const char* text, unsigned length, bool);
  bool Key(const char* text, unsigned length, bool);
  bool StartObject() { return open(JsonKind::Object); }
  bool StartArray() { return open(JsonKind::Array); }
  bool EndObject(unsigned) { return close(); }
  bool EndArray(unsigned) { return close(); }

 private:
  Value start(JsonKind kind, std::size_t offset);
  bool add(Value value);
  bool open(JsonKind kind);
  bool close();
  bool isWhole(std::string_view text);
  bool refuse(std::size_t offset, Sentence sentence);

  const Source& source_;
  Places places_;
  std::vector<Value> open_;  // innermost last
  Value root_;
  std::size_t count_ = 0;
  Stop refusal_;
};

}  // namespace underact::json
