#include "core/lab/thesis_steps.h"

#include "core/base/translate.h"

namespace underact::lab {

std::span<const ThesisStep> thesisSteps() {
  // B.3: (s + 1)(s + 2)(s + 30); its two slow parts, 5/29 / (s + 1) - 5/28 / (s + 2) = (135 - 5 s) / 812 / ((s + 1)
  // (s + 2)), of a gain a little too small; and a second order of the right gain, 1/12.
  static const std::vector<ThesisStep> all{
      {"B.1",
       TRANSLATE_NOOP("step", "First order system response"),
       TRANSLATE_NOOP("step", "a/(s + a) ends at 1, 1/(s + a) at 1/a, 3a/(s + a) at 3; here a = 2."),
       4.0,
       {{"a/(s+a)", {{2.0}, {1.0, 2.0}}}, {"1/(s+a)", {{1.0}, {1.0, 2.0}}}, {"3a/(s+a)", {{6.0}, {1.0, 2.0}}}}},
      {"B.2",
       TRANSLATE_NOOP("step", "Generic second order responses"),
       TRANSLATE_NOOP("step", "Damping ratios from 0 to 2 (twice critical), natural frequency 1 rad/s."),
       15.0,
       {{"ζ 0.4", secondOrder(1.0, 0.4)},
        {"ζ 0", secondOrder(1.0, 0.0)},
        {"ζ 0.2", secondOrder(1.0, 0.2)},
        {"ζ 0.7", secondOrder(1.0, 0.7)},
        {"ζ 1", secondOrder(1.0, 1.0)},
        {"ζ 2", secondOrder(1.0, 2.0)}}},
      {"B.3",
       TRANSLATE_NOOP("step", "Comparing third and second order responses"),
       TRANSLATE_NOOP("step",
                      "5/((s + 1)(s + 2)(s + 30)), the same without the fast part, and a second-order system with the "
                      "same gain: at most 0.0014 apart."),
       6.0,
       {{TRANSLATE_NOOP("step", "third order"), {{5.0}, {1.0, 33.0, 92.0, 60.0}}},
        {TRANSLATE_NOOP("step", "without the fast part"), {{-5.0 / 812.0, 135.0 / 812.0}, {1.0, 3.0, 2.0}}},
        {TRANSLATE_NOOP("step", "second order"), {{1.0 / 6.0}, {1.0, 3.0, 2.0}}}}},
      {"B.4",
       TRANSLATE_NOOP("step", "First order system step response"),
       TRANSLATE_NOOP("step", "a/(s + a): rise ln 9 / a, settling ln 50 / a; here a = 1."),
       6.0,
       {{"1/(s+1)", {{1.0}, {1.0, 1.0}}}}},
      {"B.5",
       TRANSLATE_NOOP("step", "Second order system step response"),
       TRANSLATE_NOOP("step",
                      "Rise, peak, overshoot of 38 % and settling; damping ratio 0.2943, natural frequency 1 rad/s."),
       18.0,
       {{"ζ 0.2943", secondOrder(1.0, 0.2943)}}}};
  return all;
}

}  // namespace underact::lab
