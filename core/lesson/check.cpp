#include "core/lesson/check.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace underact::lesson {
namespace {

bool isBetween(double number, const Criterion& wanted) {
  return number >= wanted.above && number <= wanted.below;  // not for NaN
}

/// The number that decides whether the condition holds: the measure, or its distance from where it should be.
double decidingNumber(const Criterion& wanted, const Values& values) {
  return wanted.near.empty() ? numberOf(wanted.measure, values) : distanceTo(wanted.measure, values, wanted.near);
}

bool isThere(const Criterion& wanted, double deciding) {
  return wanted.near.empty() ? isBetween(deciding, wanted) : deciding <= wanted.within;
}

const Measure* measureOf(const Task& task) {
  if (const auto* hold = std::get_if<Hold>(&task)) return &hold->wanted.measure;
  if (const auto* visit = std::get_if<Visit>(&task)) return &visit->measure;
  if (const auto* span = std::get_if<Span>(&task)) return &span->measure;
  if (const auto* cross = std::get_if<Cross>(&task)) return &cross->measure;
  const auto* number = std::get_if<AskNumber>(&task);
  return number != nullptr && number->measure.quantity != nullptr ? &number->measure : nullptr;
}

void reset(CheckState& state) {
  state.held_s = 0.0;
  state.spanning = false;
  state.side = 0;
  state.crossed_ns.clear();
}

/// Finds the first condition of Check::meanwhile that does not hold: see CheckState::missed.
void lookAside(const Check& check, CheckState& state, const Observation& seen) {
  state.missed = 0;
  for (std::size_t index = 0; index < check.meanwhile.size() && state.missed == 0; ++index) {
    const Criterion& wanted = check.meanwhile[index];
    const double number = decidingNumber(wanted, wanted.measure.quantity->of(seen));
    if (isThere(wanted, number)) continue;
    state.missed = index + 1;
    state.meanwhile_now = number;
  }
}

bool advance(const Hold& hold, CheckState& state, double gone_s) {
  if (!isThere(hold.wanted, decidingNumber(hold.wanted, state.now))) {
    state.held_s = 0.0;
    return false;
  }
  const bool was_there = state.held_s > 0.0;
  state.held_s += was_there ? gone_s : 1e-9;  // the first tick of it has no duration yet
  return state.held_s >= hold.for_s;
}

bool advance(const Visit& visit, CheckState& state, double) {
  state.visited.resize(visit.places.size(), false);
  for (std::size_t place = 0; place < visit.places.size(); ++place) {
    if (distanceTo(visit.measure, state.now, visit.places[place]) <= visit.within) state.visited[place] = true;
  }
  return std::find(state.visited.begin(), state.visited.end(), false) == state.visited.end();
}

bool advance(const Span& span, CheckState& state, double) {
  const double number = numberOf(span.measure, state.now);
  if (std::isnan(number)) return false;
  state.min = state.spanning ? std::min(state.min, number) : number;
  state.max = state.spanning ? std::max(state.max, number) : number;
  state.spanning = true;
  return state.max - state.min >= span.by;
}

bool advance(const Cross& cross, CheckState& state, double) {
  const double beyond = numberOf(cross.measure, state.now) - cross.value;
  while (!state.crossed_ns.empty() &&
         kSecondPerNanosecond * static_cast<double>(state.last_ns - state.crossed_ns.front()) > cross.in_s) {
    state.crossed_ns.pop_front();
  }
  if (!(std::abs(beyond) > cross.by)) return false;  // too near to be on either side, or not known
  const int side = beyond > 0.0 ? 1 : -1;
  if (state.side != 0 && side != state.side) state.crossed_ns.push_back(state.last_ns);
  state.side = side;
  return state.crossed_ns.size() >= static_cast<std::size_t>(cross.times);
}

bool advance(const AskNumber&, CheckState&, double) {
  return false;
}

bool advance(const AskChoice&, CheckState&, double) {
  return false;
}

}  // namespace

double numberOf(const Measure& measure, const Values& values) {
  if (measure.part > 0) return values[measure.part - 1];
  if (measure.quantity->parts == 1) return values[0];
  std::size_t known = measure.quantity->parts;
  while (known > 1 && std::isnan(values[known - 1])) --known;  // joints that the arm does not have
  double sum = 0.0;
  for (std::size_t part = 0; part < known; ++part) sum += values[part] * values[part];
  return std::sqrt(sum);
}

double distanceTo(const Measure& measure, const Values& values, const std::vector<double>& place) {
  if (measure.part > 0 || measure.quantity->parts == 1) {
    const double difference = numberOf(measure, values) - place.at(0);
    return std::abs(measure.quantity->apart == DistanceMetric::Largest ? std::remainder(difference, 360.0)
                                                                       : difference);
  }
  if (measure.quantity->apart == DistanceMetric::Angle) {
    const Vec3 is(values[0], values[1], values[2]), wanted(place.at(0), place.at(1), place.at(2));
    return std::atan2(is.cross(wanted).norm(), is.dot(wanted)) / kRadPerDegree;
  }
  double sum = 0.0, largest = 0.0;
  for (std::size_t part = 0; part < place.size() && part < values.size(); ++part) {
    if (std::isnan(place[part])) continue;  // any value
    const double difference = values[part] - place[part];
    sum += difference * difference;
    if (std::isnan(difference)) return kNotANumber;
    largest = std::max(largest, std::abs(std::remainder(difference, 360.0)));
  }
  return measure.quantity->apart == DistanceMetric::Euclidean ? std::sqrt(sum) : largest;
}

CheckState afterTick(const Check& check, CheckState state, const Observation& seen) {
  if (state.solved) return state;
  const double gone_s = kSecondPerNanosecond * static_cast<double>(seen.tick.time_ns - state.last_ns);
  if (!(gone_s >= 0.0 && gone_s <= kLongestGap_s)) reset(state);
  state.last_ns = seen.tick.time_ns;
  if (const Measure* const measure = measureOf(check.task)) {
    state.now = measure->quantity->of(seen);
    state.measured = true;
  }
  lookAside(check, state, seen);
  if (state.missed > 0) {
    reset(state);
    return state;
  }
  state.solved = std::visit([&state, gone_s](const auto& task) { return advance(task, state, gone_s); }, check.task);
  return state;
}

CheckState afterAnswer(const Check& check, CheckState state, double answer) {
  if (state.solved) return state;
  state.answer = answer;
  if (const auto* number = std::get_if<AskNumber>(&check.task)) {
    const bool is_measured = number->measure.quantity != nullptr;
    if (is_measured) {
      state.solved = state.measured && distanceTo(number->measure, state.now, {answer}) <= number->within;
    } else {
      state.solved = std::abs(answer - number->answer) <= number->within;
    }
  } else if (const auto* choice = std::get_if<AskChoice>(&check.task)) {
    state.solved = answer == static_cast<double>(choice->right);
  }
  state.solved = state.solved && state.missed == 0;
  state.is_wrong = !state.solved;
  if (state.is_wrong) state.wrong.push_back(answer);
  return state;
}

const Misconception* misconceptionOf(const Check& check, double answer) {
  constexpr double kShare = 0.05;  // of a number: `within` may be more than a wrong answer of another unit is
  const auto* const number = std::get_if<AskNumber>(&check.task);
  for (const Misconception& one : check.misconceptions) {
    const double within = number == nullptr ? 0.0 : std::min(number->within, kShare * std::abs(one.answer));
    if (std::abs(answer - one.answer) <= within) return &one;
  }
  return nullptr;
}

bool isSolved(const std::vector<CheckState>& states) {
  return std::all_of(states.begin(), states.end(), [](const CheckState& state) { return state.solved; });
}

}  // namespace underact::lesson
