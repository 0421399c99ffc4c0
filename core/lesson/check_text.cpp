#include "core/lesson/check_text.h"

#include <cmath>

#include "core/base/translate.h"

namespace underact::lesson {
namespace {

/// Describes one check.
class Teller {
 public:
  explicit Teller(const CheckState& state) : state_(state) {}

  Sentence operator()(const Hold& hold) const {
    Sentence now = is(hold.wanted.measure);
    if (!state_.solved) now = phrase(TRANSLATE_NOOP("problem", "%1; it should be %2"), {now, should(hold.wanted)});
    now = phrase("%1.", {now});
    if (!(hold.for_s > 0.0)) return now;
    const Sentence held =
        phrase(TRANSLATE_NOOP("problem", "Held for %1 of %2 s."),
               {shownNumber(state_.solved ? hold.for_s : state_.held_s, 1), shownNumber(hold.for_s, 1)});
    return oneAfterAnother({held, now});
  }

  Sentence operator()(const Visit& visit) const {
    Sentence left;
    std::size_t count = 0;
    for (std::size_t index = 0; index < visit.places.size(); ++index) {
      if (index < state_.visited.size() && state_.visited[index]) {
        ++count;
        continue;
      }
      const Sentence next = place(visit.measure, visit.places[index]);
      left = left.empty() ? next : phrase("%1, %2", {left, next});
    }
    const Sentence reached = phrase(TRANSLATE_NOOP("problem", "%1 of %2 reached."),
                                    {std::to_string(count), std::to_string(visit.places.size())});
    if (left.empty()) return reached;
    return oneAfterAnother({reached, phrase(TRANSLATE_NOOP("problem", "Still to reach: %1, to within %2. %3."),
                                            {left, distance(visit.measure, visit.within), is(visit.measure)})});
  }

  Sentence operator()(const Span& span) const {
    const double by = state_.spanning ? state_.max - state_.min : 0.0;
    return phrase(TRANSLATE_NOOP("problem", "%1 moved through %2; required: %3."),
                  {name(span.measure), amount(span.measure, by), amount(span.measure, span.by)});
  }

  Sentence operator()(const Cross& cross) const {
    return phrase(TRANSLATE_NOOP("problem", "%1 crossed %2 %3 of %4 times within %5 s."),
                  {name(cross.measure), amount(cross.measure, cross.value), std::to_string(state_.crossed_ns.size()),
                   std::to_string(cross.times), shownNumber(cross.in_s, 1)});
  }

  Sentence operator()(const AskNumber& ask) const {
    if (!state_.answer) return phrase(TRANSLATE_NOOP("problem", "Type your answer."));
    return answered(withUnit(*state_.answer, decimalsOf(*state_.answer), ask.unit));
  }

  Sentence operator()(const AskChoice& ask) const {
    const auto number = static_cast<std::size_t>(state_.answer.value_or(0.0));
    if (number < 1 || number > ask.choices.size()) return phrase(TRANSLATE_NOOP("problem", "Choose an answer."));
    return answered(phrase("“%1”", {ask.choices[number - 1]}));
  }

  Sentence meanwhile(const Criterion& wanted) const {
    const Sentence now = wanted.near.empty() ? amount(wanted.measure, state_.meanwhile_now)
                                             : distance(wanted.measure, state_.meanwhile_now);
    return phrase(TRANSLATE_NOOP("problem", "Required at the same time: %1 %2; now %3."),
                  {name(wanted.measure), should(wanted), now});
  }

 private:
  /// The number of decimals with which it was probably typed.
  static int decimalsOf(double number) {
    int decimals = 0;
    for (double scaled = number; decimals < 4 && std::abs(scaled - std::round(scaled)) > 1e-9 * std::abs(scaled);) {
      scaled *= 10.0;
      ++decimals;
    }
    return decimals;
  }

  Sentence answered(const Sentence& answer) const {
    return phrase(state_.solved ? TRANSLATE_NOOP("problem", "%1 is correct.")
                                : TRANSLATE_NOOP("problem", "%1 is not correct. Try again."),
                  {answer});
  }

  static Sentence name(const Measure& measure) {
    const Sentence whole = phrase(measure.quantity->name);
    if (measure.part == 0 || measure.quantity->parts <= 1) return whole;
    const bool has_axes = measure.quantity->parts == 3 && measure.quantity->apart != DistanceMetric::Largest;
    return phrase("%1 %2", {whole, has_axes ? std::string(1, "xyz"[measure.part - 1]) : std::to_string(measure.part)});
  }

  static Sentence withUnit(double number, int decimals, const std::string& unit) {
    if (std::isnan(number)) return phrase(TRANSLATE_NOOP("problem", "not known"));
    const Sentence digits = shownNumber(number, decimals);
    return unit.empty() ? digits : phrase(unit == "°" ? "%1%2" : "%1 %2", {digits, unit});
  }

  static Sentence amount(const Measure& measure, double number) {
    return withUnit(number, measure.quantity->decimals, measure.quantity->unit);
  }

  static Sentence distance(const Measure& measure, double number) {
    return withUnit(number, measure.quantity->decimals, unitOfDistance(*measure.quantity));
  }

  /// "(1.0, 2.0, 3.0) mm"; parts: kMaxParts at most.
  static Sentence place(const Measure& measure, const std::vector<double>& parts) {
    if (parts.size() == 1) return amount(measure, parts[0]);
    std::string pattern;
    std::vector<Sentence> digits;
    for (const double number : parts) {
      digits.push_back(shownNumber(number, measure.quantity->decimals));
      pattern += (pattern.empty() ? "(%" : ", %") + std::to_string(digits.size());
    }
    const Sentence all = phrase(pattern + ")", std::move(digits));
    return measure.quantity->unit[0] == '\0' ? all : phrase("%1 %2", {all, measure.quantity->unit});
  }

  /// "The force is 0.12 N"
  Sentence is(const Measure& measure) const {
    if (!state_.measured) return phrase(TRANSLATE_NOOP("problem", "%1 is not measured yet"), {name(measure)});
    Sentence value;
    if (measure.part > 0 || measure.quantity->parts == 1) {
      value = amount(measure, numberOf(measure, state_.now));
    } else {
      std::vector<double> all(state_.now.begin(), state_.now.begin() + static_cast<long>(measure.quantity->parts));
      while (!all.empty() && std::isnan(all.back())) all.pop_back();  // a robot of fewer joints
      value = all.empty() ? withUnit(kNotANumber, 0, "") : place(measure, all);
    }
    return phrase(TRANSLATE_NOOP("problem", "%1 is %2"), {name(measure), value});
  }

  /// "above 0.30 N"
  static Sentence should(const Criterion& wanted) {
    const Measure& measure = wanted.measure;
    if (!wanted.near.empty() && !(wanted.within > 0.0)) return place(measure, wanted.near);  // a count
    if (!wanted.near.empty())
      return phrase(TRANSLATE_NOOP("problem", "within %1 of %2"),
                    {distance(measure, wanted.within), place(measure, wanted.near)});
    const Sentence above = amount(measure, wanted.above), below = amount(measure, wanted.below);
    if (!std::isfinite(wanted.above)) return phrase(TRANSLATE_NOOP("problem", "below %1"), {below});
    if (!std::isfinite(wanted.below)) return phrase(TRANSLATE_NOOP("problem", "above %1"), {above});
    return phrase(TRANSLATE_NOOP("problem", "between %1 and %2"), {above, below});
  }

  const CheckState& state_;
};

}  // namespace

Sentence describeCheck(const Check& check, const CheckState& state) {
  const Teller teller(state);
  const Sentence task = std::visit(teller, check.task);
  if (state.solved) return task;
  return oneAfterAnother(
      {check.say, task, state.missed > 0 ? teller.meanwhile(check.meanwhile[state.missed - 1]) : Sentence()});
}

}  // namespace underact::lesson
