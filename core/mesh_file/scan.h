#pragma once
#include <charconv>
#include <string>
#include <string_view>

namespace underact::mesh_file {

/// White space of ASCII, whatever the locale.
inline bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/// The letters A to Z in lower case, whatever the locale; others stay.
inline std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Words of a text between blanks, with the line that each is on.
class Scan {
 public:
  /// text: outlives this and the words that it gives. A byte order mark at its start is left out.
  explicit Scan(std::string_view text) : text_(text), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  /// The next word; empty: there is none.
  std::string_view word() {
    while (at_ < text_.size() && isSpace(text_[at_])) step();
    const std::size_t start = at_;
    while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }

  /// The rest of the line, without its end; any of \n, \r\n and \r ends one.
  std::string_view line() {
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    const std::string_view rest = text_.substr(start, at_ - start);
    if (at_ < text_.size()) {
      const bool pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
      at_ += pair ? 2 : 1;
      ++line_;
    }
    return rest;
  }

  /// Whether all was read; blanks at the end count as not read.
  bool atEnd() const { return at_ >= text_.size(); }
  /// The byte offset of what comes next, and the number of its line, from 1.
  std::size_t place() const { return at_; }
  int lineNumber() const { return line_; }

 private:
  void step() {
    const bool ends = text_[at_] == '\n' || (text_[at_] == '\r' && (at_ + 1 >= text_.size() || text_[at_ + 1] != '\n'));
    line_ += ends ? 1 : 0;
    ++at_;
  }
  std::string_view text_;
  std::size_t at_;
  int line_ = 1;
};

/// A whole number and nothing else.
template <class Integer>
bool readInteger(std::string_view word, Integer& value) {
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  return !word.empty() && read.ec == std::errc() && read.ptr == word.data() + word.size();
}

}  // namespace underact::mesh_file
