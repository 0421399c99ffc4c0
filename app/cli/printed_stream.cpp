#include "app/cli/printed_stream.h"

#include <string_view>

#include "core/base/printed.h"

namespace underact::cli {

std::streambuf::int_type PrintedStream::overflow(std::streambuf::int_type letter) {
  const char text = std::streambuf::traits_type::to_char_type(letter);
  return xsputn(&text, 1) == 1 ? letter : std::streambuf::traits_type::eof();
}

std::streamsize PrintedStream::xsputn(const char* text, std::streamsize count) {
  const std::string_view given(text, static_cast<std::size_t>(count));
  std::size_t from = 0;  // of what is kept as it is
  for (std::size_t at = 0; at < given.size(); ++at) {
    const std::size_t length = given[at] == '\n' || given[at] == '\t' ? 0 : controlLength(given, at);
    if (length == 0 || given == "\r") continue;
    to_ << given.substr(from, at - from) << shownControl(given.substr(at));
    at += length - 1;
    from = at + 1;
  }
  return to_ << given.substr(from) ? count : 0;
}

}  // namespace underact::cli
