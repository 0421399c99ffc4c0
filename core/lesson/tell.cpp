#include "core/lesson/tell.h"

#include <charconv>
#include <cmath>

#include "core/base/sentence.h"
#include "core/base/translate.h"

namespace underact::lesson {
namespace {

/// Says one check; holds what each sentence needs.
class Teller {
 public:
  Teller(const CheckState& state, const Speech& speech) : state_(state), speech_(speech) {}

  std::string operator()(const Hold& hold) const {
    std::string said = is(hold.wanted.measure);
    if (!state_.solved)
      said = filled(words(QT_TRANSLATE_NOOP("lesson", "%1; it should be %2")), {said, should(hold.wanted)});
    if (!(hold.for_s > 0.0)) return said + ".";
    const std::vector<std::string> times{speech_.number(state_.solved ? hold.for_s : state_.held_s, 1),
                                         speech_.number(hold.for_s, 1)};
    return filled(words(QT_TRANSLATE_NOOP("lesson", "Held for %1 of %2 s.")), times) + " " + said + ".";
  }

  std::string operator()(const Visit& visit) const {
    std::string left;
    std::size_t count = 0;
    for (std::size_t place = 0; place < visit.places.size(); ++place) {
      if (place < state_.visited.size() && state_.visited[place]) {
        ++count;
        continue;
      }
      left += (left.empty() ? "" : ", ") + this->place(visit.measure, visit.places[place]);
    }
    const std::string said = filled(words(QT_TRANSLATE_NOOP("lesson", "%1 of %2 reached.")),
                                    {std::to_string(count), std::to_string(visit.places.size())});
    if (left.empty()) return said;
    return said + " " +
           filled(words(QT_TRANSLATE_NOOP("lesson", "Still to go: %1, to %2. %3.")),
                  {left, distance(visit.measure, visit.within), is(visit.measure)});
  }

  std::string operator()(const Span& span) const {
    const double by = state_.spanning ? state_.most - state_.least : 0.0;
    return filled(words(QT_TRANSLATE_NOOP("lesson", "%1 went over %2 of %3.")),
                  {name(span.measure), amount(span.measure, by), amount(span.measure, span.by)});
  }

  std::string operator()(const Cross& cross) const {
    return filled(words(QT_TRANSLATE_NOOP("lesson", "%1 swung through %2 %3 of %4 times within %5 s.")),
                  {name(cross.measure), amount(cross.measure, cross.value), std::to_string(state_.crossed_ns.size()),
                   std::to_string(cross.times), speech_.number(cross.in_s, 1)});
  }

  std::string operator()(const AskNumber& ask) const {
    if (!state_.answer) return words(QT_TRANSLATE_NOOP("lesson", "Type your answer."));
    return answered(withUnit(*state_.answer, decimalsOf(*state_.answer), ask.unit.c_str()));
  }

  std::string operator()(const AskChoice& ask) const {
    const auto number = static_cast<std::size_t>(state_.answer.value_or(0.0));
    if (number < 1 || number > ask.choices.size()) return words(QT_TRANSLATE_NOOP("lesson", "Choose an answer."));
    return answered("“" + ask.choices[number - 1] + "”");
  }

  std::string meanwhile(const Wanted& wanted) const {
    const std::string now = wanted.near.empty() ? amount(wanted.measure, state_.meanwhile_now)
                                                : distance(wanted.measure, state_.meanwhile_now);
    return filled(words(QT_TRANSLATE_NOOP("lesson", "At the same time it should be: %1 %2; now %3.")),
                  {name(wanted.measure), should(wanted), now});
  }

 private:
  std::string words(const char* text) const { return speech_.words(text); }

  /// As many as it was probably typed with.
  static int decimalsOf(double number) {
    int decimals = 0;
    for (double scaled = number; decimals < 4 && std::abs(scaled - std::round(scaled)) > 1e-9 * std::abs(scaled);) {
      scaled *= 10.0;
      ++decimals;
    }
    return decimals;
  }

  std::string answered(const std::string& answer) const {
    return filled(words(state_.solved ? QT_TRANSLATE_NOOP("lesson", "%1 is right.")
                                      : QT_TRANSLATE_NOOP("lesson", "%1 is not right. Look again.")),
                  {answer});
  }

  std::string name(const Measure& measure) const {
    std::string said = words(measure.quantity->name);
    if (measure.part > 0 && measure.quantity->parts > 1) {
      const bool has_axes = measure.quantity->parts == 3 && measure.quantity->apart != Apart::Largest;
      said += has_axes ? std::string(" ") + "xyz"[measure.part - 1] : " " + std::to_string(measure.part);
    }
    return said;
  }

  std::string withUnit(double number, int decimals, const char* unit) const {
    if (std::isnan(number)) return words(QT_TRANSLATE_NOOP("lesson", "not known"));
    const bool is_angle = std::string(unit) == "°";
    return speech_.number(number, decimals) + (unit[0] == '\0' || is_angle ? "" : " ") + unit;
  }

  std::string amount(const Measure& measure, double number) const {
    return withUnit(number, measure.quantity->decimals, measure.quantity->unit);
  }

  std::string distance(const Measure& measure, double number) const {
    return withUnit(number, measure.quantity->decimals, unitOfDistance(*measure.quantity));
  }

  std::string place(const Measure& measure, const std::vector<double>& place) const {
    if (place.size() == 1) return amount(measure, place[0]);
    std::string said;
    for (const double number : place) {
      said += (said.empty() ? "(" : ", ");
      said += std::isnan(number) ? "–" : speech_.number(number, measure.quantity->decimals);
    }
    return withUnitAfter(said + ")", measure);
  }

  static std::string withUnitAfter(const std::string& said, const Measure& measure) {
    return measure.quantity->unit[0] == '\0' ? said : said + " " + measure.quantity->unit;
  }

  /// "The force is 0.12 N"
  std::string is(const Measure& measure) const {
    if (!state_.measured) return filled(words(QT_TRANSLATE_NOOP("lesson", "%1 is not measured yet")), {name(measure)});
    std::string value;
    if (measure.part > 0 || measure.quantity->parts == 1) {
      value = amount(measure, numberOf(measure, state_.now));
    } else {
      std::vector<double> all(state_.now.begin(), state_.now.begin() + static_cast<long>(measure.quantity->parts));
      while (!all.empty() && std::isnan(all.back())) all.pop_back();  // a robot of fewer joints
      value = all.empty() ? withUnit(kNotANumber, 0, "") : place(measure, all);
    }
    return filled(words(QT_TRANSLATE_NOOP("lesson", "%1 is %2")), {name(measure), value});
  }

  /// "above 0.30 N"
  std::string should(const Wanted& wanted) const {
    const Measure& measure = wanted.measure;
    if (!wanted.near.empty() && !(wanted.within > 0.0)) return place(measure, wanted.near);  // a count
    if (!wanted.near.empty())
      return filled(words(QT_TRANSLATE_NOOP("lesson", "within %1 of %2")),
                    {distance(measure, wanted.within), place(measure, wanted.near)});
    const std::string above = amount(measure, wanted.above), below = amount(measure, wanted.below);
    if (!std::isfinite(wanted.above)) return filled(words(QT_TRANSLATE_NOOP("lesson", "below %1")), {below});
    if (!std::isfinite(wanted.below)) return filled(words(QT_TRANSLATE_NOOP("lesson", "above %1")), {above});
    return filled(words(QT_TRANSLATE_NOOP("lesson", "between %1 and %2")), {above, below});
  }

  const CheckState& state_;
  const Speech& speech_;
};

}  // namespace

Speech::Speech()
    : number([](double value, int decimals) {
        char text[400];  // of the largest double, too
        const double rounded = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;  // no -0.0
        const auto end = std::to_chars(text, text + sizeof text, rounded, std::chars_format::fixed, decimals).ptr;
        return std::string(text, end);
      }) {}

std::string tell(const Check& check, const CheckState& state, const Speech& speech) {
  const Teller teller(state, speech);
  std::string said = std::visit(teller, check.task);
  if (state.solved) return said;
  if (state.missed > 0) said += " " + teller.meanwhile(check.meanwhile[state.missed - 1]);
  return check.say.empty() ? said : check.say + " " + said;
}

}  // namespace underact::lesson
