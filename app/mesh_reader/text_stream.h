#pragma once
#include <algorithm>
#include <functional>
#include <streambuf>
#include <string_view>

namespace underact::mesh_reader {

/// Text in memory as a stream, in 100 pieces, so that the progress is known.
class TextStream : public std::streambuf {
 public:
  /// passes: how often the text is read from its beginning.
  TextStream(std::string_view text, int passes, std::function<void(double share)> progress)
      : text_(text), passes_(passes), progress_(std::move(progress)) {
    show(0);
  }

 protected:
  int_type underflow() override {
    const std::size_t next = start_ + static_cast<std::size_t>(egptr() - eback());
    if (gptr() < egptr()) return traits_type::to_int_type(*gptr());
    if (next >= text_.size()) return traits_type::eof();
    tell(next);
    show(next);
    return traits_type::to_int_type(*gptr());
  }
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode /*mode*/) override {
    const auto here = static_cast<off_type>(start_) + (gptr() - eback());
    const off_type base = from == std::ios_base::beg ? 0 : from == std::ios_base::cur ? here : size();
    const off_type to = base + offset;
    if (to < 0 || to > size()) return pos_type(off_type(-1));
    if (to == here) return to;
    if (to == 0) ++pass_;
    show(static_cast<std::size_t>(to));
    return to;
  }
  pos_type seekpos(pos_type to, std::ios_base::openmode mode) override {
    return seekoff(off_type(to), std::ios_base::beg, mode);
  }

 private:
  off_type size() const { return static_cast<off_type>(text_.size()); }
  void show(std::size_t start) {
    constexpr std::size_t kPieces = 100, kSmallest = 4096;
    start_ = std::min(start, text_.size());
    const std::size_t end = std::min(start_ + std::max(text_.size() / kPieces, kSmallest), text_.size());
    char* begin = const_cast<char*>(text_.data());  // a stream's buffer is not const; nothing writes to it
    setg(begin + start_, begin + start_, begin + end);
  }
  void tell(std::size_t at) {
    const double share = static_cast<double>(at) / static_cast<double>(text_.size());
    const double whole = (std::min(pass_, passes_ - 1) + share) / passes_;
    if (progress_ && whole > told_) progress_(told_ = whole);
  }
  std::string_view text_;
  int passes_;
  std::function<void(double share)> progress_;
  std::size_t start_ = 0;  // of the piece, in the text
  int pass_ = 0;
  double told_ = 0.0;
};

}  // namespace underact::mesh_reader
