#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace underact::json {

/// The kinds of JSON values.
enum class JsonKind { Null, Bool, Number, String, Array, Object };

/// A JSON value with the line and column it was read from, which every problem names. Files here are small.
struct Value {
  JsonKind kind = JsonKind::Null;
  bool boolean = false;
  double number = 0.0;                          // not finite where the text is too large for a double
  std::string text;                             // of a string; of a number as it stands there
  std::vector<Value> items;                     // of an array; of an object, in the order of its keys
  std::vector<std::string> keys;                // of an object, in the order of the file
  std::vector<std::pair<int, int>> key_places;  // line and column of each key
  int line = 0;                                 // of its first character, from 1
  int column = 0;                               // in characters (code points), from 1

  /// The member of an object, or null. Where a key stands twice, the first.
  const Value* find(std::string_view key) const;
};

/// Problems: one, where the text stops being JSON (RFC 8259, UTF-8, at most 64 levels deep), in plain words.
Result<Value> parse(std::string_view text, const std::string& file_name);

/// A number as the shortest text that reads back to the same double, in Python too: -0 is "-0.0". Not finite: "null".
std::string numberText(double value);

/// A string with quotes, escaped.
std::string quotedText(std::string_view text);

}  // namespace underact::json
