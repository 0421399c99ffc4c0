#pragma once
#include "core/base/sentence.h"
#include "core/lesson/check.h"

namespace underact::lesson {

/// Progress of a check: "Held for 0.6 of 2.0 s. The force is 0.12 N; it should be above 0.30 N." Solved: what was
/// measured then. One line of plain text; the teacher's own words come first.
Sentence describeCheck(const Check& check, const CheckState& state);

}  // namespace underact::lesson
