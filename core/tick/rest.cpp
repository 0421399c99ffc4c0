#include "core/tick/rest.h"

#include "core/tick/step.h"

namespace underact::tick {

TickReport answerAtRest(const TickProgram& program, const Vec3& p_WT) {
  // An arm without length whose base stands where the tip is meant to be: its tip is there to the last bit, for places
  // that the real arm cannot reach, too.
  TickProgram there = program;
  there.geometry = {0.0, 0.0, p_WT};
  TickState state = makeState(there);
  TickReport report;
  step(there, TickInput{}, state, report);
  return report;
}

}  // namespace underact::tick
