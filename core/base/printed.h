#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace underact {

/// Bytes of the UTF-8 character that starts at `at`; 0 where it is invalid (overlong, a surrogate, cut off).
std::size_t characterLength(std::string_view text, std::size_t at) noexcept;

/// Bytes of the control character at `at`: C0 (a line break, too), DEL, C1, and those that Unicode reorders or breaks
/// lines with (U+202E). 0: another character.
std::size_t controlLength(std::string_view text, std::size_t at) noexcept;

/// How the control character at the start is shown, "\u001b": as JSON escapes it.
std::string shownControl(std::string_view text);

/// A name, a note or a sentence that others wrote, for a line that is printed: it stays one line, and a terminal does
/// nothing but show it. Control characters as shownControl(); what is not UTF-8, as U+FFFD.
std::string printed(std::string_view words);

}  // namespace underact
