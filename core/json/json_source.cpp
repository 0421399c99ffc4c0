#include "core/json/json_source.h"

#include <algorithm>

namespace underact::json {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Removes the digits at the front; false where there are none.
bool takeDigits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count > 0;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// RFC 8259, section 6.
bool isNumber(std::string_view text) {
  take(text, "-");
  if (!take(text, "0") && !takeDigits(text)) return false;
  if (take(text, ".") && !takeDigits(text)) return false;
  if (take(text, "eE")) {
    take(text, "+-");
    if (!takeDigits(text)) return false;
  }
  return text.empty();
}

}  // namespace

void Source::arrive() {
  shown_ = at_ < text_.size() ? text_[at_] : '\0';
  if (in_string_ || at_ < raw_end_ || !(shown_ == '-' || isDigit(shown_))) return;
  const std::size_t end = std::min(text_.find_first_not_of("0123456789+-.eE", at_), text_.size());
  if (!isNumber(text_.substr(at_, end - at_))) {
    raw_end_ = end;
    return;
  }
  number_start_ = at_;
  number_end_ = end;
  shown_ = '0';
}

char Source::Take() {
  const char taken = shown_;
  if (at_ >= text_.size()) return taken;
  if (!in_string_ && at_ == number_start_ && number_end_ > at_) {
    at_ = number_end_;
  } else {
    if (in_string_ && !escaped_ && taken == '\\') {
      escaped_ = true;
    } else {
      if (taken == '"' && !escaped_) {
        if (!in_string_) string_start_ = at_;
        in_string_ = !in_string_;
      }
      escaped_ = false;
    }
    ++at_;
  }
  arrive();
  return taken;
}

std::pair<int, int> Places::at(std::size_t offset) {
  for (; at_ < std::min(offset, text_.size()); ++at_) {
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (c == '\n') {
      ++line_;
      column_ = 1;
    } else if ((c & 0xC0U) != 0x80U) {
      ++column_;
    }
  }
  return {line_, column_};
}

}  // namespace underact::json
