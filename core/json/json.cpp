#include "core/json/json.h"

#include <rapidjson/reader.h>

#include <algorithm>
#include <utility>

#include "core/base/translate.h"
#include "core/json/json_builder.h"
#include "core/json/json_source.h"
#include "core/json/text.h"

namespace underact::json {
namespace {

class ReaderMemory : public rapidjson::CrtAllocator {};  // a type of our own, to be seen in the next lines

}  // namespace
}  // namespace underact::json

/// RapidJSON 1.1 adds to the null pointer of its empty stack, which sanitizers report. Corrected as in later versions,
/// for our reader alone.
template <>
template <class T>
void rapidjson::internal::Stack<underact::json::ReaderMemory>::Reserve(std::size_t count) {
  if (sizeof(T) * count > static_cast<std::size_t>(stackEnd_ - stackTop_)) Expand<T>(count);
}

namespace underact::json {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

char charAt(std::string_view text, std::size_t at) {
  return at < text.size() ? text[at] : '\0';
}

bool isWordChar(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' || c == '+' || c == '-';
}

bool followsComma(std::string_view text, std::size_t at) {
  const std::size_t last = text.substr(0, at).find_last_not_of(kBlank);
  return last != std::string_view::npos && text[last] == ',';
}

Stop explainValue(std::string_view text, std::size_t at) {
  while (at > 0 && isWordChar(text[at - 1])) --at;  // to where the word begins
  const char c = charAt(text, at);
  if (at >= text.size())
    return {at, phrase(TRANSLATE_NOOP("problem", "The text ends too early: a value was expected."))};
  if ((c == ']' || c == '}') && followsComma(text, at)) {
    return {at, phrase(TRANSLATE_NOOP(
                    "problem", "There is a comma before this bracket; remove it, or write another value after it."))};
  }
  if (c == '\'') return {at, phrase(TRANSLATE_NOOP("problem", "Text must be in double quotes, not in single ones."))};
  if (c == '/' || c == '#') return {at, phrase(TRANSLATE_NOOP("problem", "JSON has no comments; remove this."))};
  if (isWordChar(c)) {
    return {
        at,
        phrase(TRANSLATE_NOOP(
                   "problem",
                   "A value was expected; %1 is not one. Numbers look like 0.5, -3 or 1e-3; text is in double quotes."),
               {shown(text.substr(at, text.find_first_of(",:]} \t\r\n\"", at) - at))})};
  }
  return {at,
          phrase(TRANSLATE_NOOP(
              "problem", "A value was expected: a number, text in double quotes, a list in [ ] or an object in { }."))};
}

Stop explainKey(std::string_view text, std::size_t at) {
  if (at >= text.size())
    return {at,
            phrase(TRANSLATE_NOOP("problem", "The text ends too early: a key in double quotes or a } was expected."))};
  if (text[at] == '}')
    return {at, phrase(TRANSLATE_NOOP("problem",
                                      "There is a comma before this }; remove it, or write another key after it."))};
  if (text[at] == '/' || text[at] == '#') return explainValue(text, at);
  return {at, phrase(TRANSLATE_NOOP("problem", "A key in double quotes was expected."))};
}

Stop explainEnd(std::string_view text, std::size_t at, const char* bracket) {
  if (at >= text.size())
    return {at, phrase(TRANSLATE_NOOP("problem", "The text ends too early: a %1 is missing."), {bracket})};
  if (text[at] == '/' || text[at] == '#') return explainValue(text, at);
  return {at, phrase(TRANSLATE_NOOP("problem", "A comma or a %1 was expected here."), {bracket})};
}

Stop explainText(std::string_view text, std::size_t at, const Source& source) {
  if (at >= text.size())
    return {source.stringStart(),
            phrase(TRANSLATE_NOOP("problem", "This text is not closed: its second double quote is missing."))};
  if (text[at] == '\n' || text[at] == '\r') {
    return {
        source.stringStart(),
        phrase(TRANSLATE_NOOP("problem", "This text does not end on its line: its second double quote is missing."))};
  }
  if (text[at] == '\\') {
    return {at, phrase(TRANSLATE_NOOP(
                    "problem", "JSON does not know this escape; a backslash itself is written \\\\, a new line \\n."))};
  }
  return {at, phrase(TRANSLATE_NOOP("problem", "There is a control character in this text; a tab is written \\t."))};
}

Stop explain(const rapidjson::ParseResult& error, std::string_view text, const Source& source) {
  const std::size_t at = error.Offset();
  switch (error.Code()) {
    case rapidjson::kParseErrorDocumentEmpty:
      return {at, phrase(TRANSLATE_NOOP("problem", "The file is empty; an object in { } was expected."))};
    case rapidjson::kParseErrorDocumentRootNotSingular:
      return {at, phrase(TRANSLATE_NOOP("problem", "The text should end before this: all its brackets are closed."))};
    case rapidjson::kParseErrorObjectMissName:
      return explainKey(text, at);
    case rapidjson::kParseErrorObjectMissColon:
      return {at, phrase(TRANSLATE_NOOP("problem", "A colon was expected after the key."))};
    case rapidjson::kParseErrorObjectMissCommaOrCurlyBracket:
      return explainEnd(text, at, "}");
    case rapidjson::kParseErrorArrayMissCommaOrSquareBracket:
      return explainEnd(text, at, "]");
    case rapidjson::kParseErrorStringUnicodeEscapeInvalidHex:
      return {at, phrase(TRANSLATE_NOOP("problem", "Four digits of 0-9 and a-f are expected after \\u."))};
    case rapidjson::kParseErrorStringUnicodeSurrogateInvalid:
      return {at, phrase(TRANSLATE_NOOP("problem", "This \\u escape is half of a pair; its other half is missing."))};
    case rapidjson::kParseErrorStringEscapeInvalid:
    case rapidjson::kParseErrorStringMissQuotationMark:
      return explainText(text, at, source);
    default:
      return explainValue(text, at);
  }
}

Problems problemAt(const Stop& stop, std::string_view text, const std::string& file_name) {
  const auto [line, column] = Places(text).at(stop.offset);
  return {{stop.sentence, {file_name, line, column, ""}}};
}

}  // namespace

const Value* Value::find(std::string_view key) const {
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &items[static_cast<std::size_t>(found - keys.begin())];
}

Result<Value> parse(std::string_view text, const std::string& file_name) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);  // a byte order mark
  for (std::size_t at = 0, length = 0; at < text.size(); at += length) {
    length = text[at] == '\0' ? 0 : codePointLength(text, at);
    if (length == 0)
      return problemAt({at, phrase(TRANSLATE_NOOP("problem", "This is not text in UTF-8; save the file as UTF-8."))},
                       text, file_name);
  }
  Source source(text);
  Builder builder(source, text);
  rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, ReaderMemory> reader;
  const rapidjson::ParseResult parsed = reader.Parse<rapidjson::kParseIterativeFlag>(source, builder);
  if (!parsed.IsError()) return builder.takeRoot();
  const bool refused = !builder.refusal().sentence.empty();
  return problemAt(refused ? builder.refusal() : explain(parsed, text, source), text, file_name);
}

}  // namespace underact::json
