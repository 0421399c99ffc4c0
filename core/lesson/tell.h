#pragma once
#include <functional>
#include <string>

#include "core/lesson/check.h"

namespace underact::lesson {

/// How sentences and numbers are said: in whose language, with which decimal sign. As they stand by itself.
struct Speech {
  /// A text of this room in the reader's language.
  std::function<std::string(const char* text)> words = [](const char* text) { return std::string(text); };
  std::function<std::string(double number, int decimals)> number;
  Speech();
};

/// What has been done and what is missing: "Held for 0.6 of 2.0 s. The force is 0.12 N; it should be above 0.30 N."
/// Solved: what was measured then. One line of plain text; the teacher's own words come first.
std::string tell(const Check& check, const CheckState& state, const Speech& speech);

}  // namespace underact::lesson
