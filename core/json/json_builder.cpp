#include "core/json/json_builder.h"

#include <tuple>
#include <utility>

#include "core/base/translate.h"
#include "core/json/text.h"

namespace underact::json {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMaxValues = 1'000'000;  // about 150 bytes each

}  // namespace

bool Builder::Bool(bool value) {
  Value made = start(JsonKind::Bool, source_.Tell() - (value ? 4U : 5U));
  made.boolean = value;
  return add(std::move(made));
}

bool Builder::Uint(unsigned) {
  Value made = start(JsonKind::Number, source_.numberStart());
  made.text = source_.number();
  made.number = numberOf(made.text);
  return add(std::move(made));
}

bool Builder::String(const char* text, unsigned length, bool) {
  Value made = start(JsonKind::String, source_.stringStart());
  made.text.assign(text, length);
  return isWhole(made.text) && add(std::move(made));
}

bool Builder::Key(const char* text, unsigned length, bool) {
  Value& object = open_.back();
  object.keys.emplace_back(text, length);
  object.key_places.push_back(places_.at(source_.stringStart()));
  return isWhole(object.keys.back());
}

Value Builder::start(JsonKind kind, std::size_t offset) {
  Value value;
  value.kind = kind;
  std::tie(value.line, value.column) = places_.at(offset);
  return value;
}

bool Builder::add(Value value) {
  if (++count_ > kMaxValues) {
    return refuse(
        source_.Tell(),
        phrase(TRANSLATE_NOOP("problem", "The file contains more than a million values; a scene is far smaller.")));
  }
  (open_.empty() ? root_ : open_.back().items.emplace_back()) = std::move(value);
  return true;
}

bool Builder::open(JsonKind kind) {
  if (open_.size() >= kDeepest)
    return refuse(source_.Tell(),
                  phrase(TRANSLATE_NOOP("problem", "Lists and objects are nested more than 64 levels deep here.")));
  open_.push_back(start(kind, source_.Tell()));
  return true;
}

bool Builder::close() {
  Value value = std::move(open_.back());
  open_.pop_back();
  return add(std::move(value));
}

/// Whether the text is valid: the bytes of the file are UTF-8 already, but RapidJSON accepts the second half of a \u
/// pair alone.
bool Builder::isWhole(std::string_view text) {
  for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
    length = codePointLength(text, at);
    if (length == 0) {
      return refuse(
          source_.stringStart(),
          phrase(TRANSLATE_NOOP("problem", "A \\u escape in this text is half of a pair; its other half is missing.")));
    }
  }
  return true;
}

bool Builder::refuse(std::size_t offset, Sentence sentence) {
  refusal_ = {offset, std::move(sentence)};
  return false;
}

}  // namespace underact::json
