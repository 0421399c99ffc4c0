#pragma once
#include <cstddef>
#include <string_view>
#include <utility>

namespace underact::json {

/// The text as RapidJSON reads it: a stream that knows where values start. RapidJSON 1.1 stops at a number beyond
/// double even when told to keep numbers as text, so a well-formed number is shown to it as a lone 0, and is read here.
class Source {
 public:
  // RapidJSON's stream concept, for reading only; the text outlives the source.
  using Ch = char;
  explicit Source(std::string_view text) : text_(text) { arrive(); }
  char Peek() const { return shown_; }
  char Take();
  std::size_t Tell() const { return at_; }
  char* PutBegin() { return nullptr; }  // for streams that are written to
  void Put(char) {}
  void Flush() {}
  std::size_t PutEnd(char*) { return 0; }

  std::size_t stringStart() const { return string_start_; }  // of the last string
  std::size_t numberStart() const { return number_start_; }  // of the last number
  /// The text of the last number.
  std::string_view number() const { return text_.substr(number_start_, number_end_ - number_start_); }

 private:
  void arrive();
  std::string_view text_;
  std::size_t at_ = 0;
  char shown_ = '\0';
  bool in_string_ = false;
  bool escaped_ = false;
  std::size_t string_start_ = 0;
  std::size_t number_start_ = 0;
  std::size_t number_end_ = 0;
  std::size_t raw_end_ = 0;  // up to here something like a number that is none
};

/// Line and column (in code points), from 1, of offsets asked for in growing order.
class Places {
 public:
  /// text: UTF-8; it outlives this.
  explicit Places(std::string_view text) : text_(text) {}
  /// Line and column of a byte offset, not below the one asked for before; beyond the text: those of its end.
  std::pair<int, int> at(std::size_t offset);

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int column_ = 1;
};

}  // namespace underact::json
