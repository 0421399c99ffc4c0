#include "core/identify/measurement.h"

#include <algorithm>
#include <utility>

#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::identify {

Measurement::Measurement(Plan plan, Put put) : plan_(std::move(plan)), put_(std::move(put)) {}

double Measurement::share() const {
  return state_ == State::Done ? 1.0 : std::min(1.0, (before_s_ + stage_s_) / plan_.seconds());
}

Problems Measurement::go() {
  return state_ == State::Asks ? begin() : Problems{};
}

/// Puts the stage's scene into effect.
Problems Measurement::begin() {
  const Result<std::uint64_t> revision = put_(stage().scene);
  if (!revision) return revision.problems();
  revision_ = revision.value();
  begun_ns_ = -1;
  stage_s_ = 0.0;
  state_ = State::Runs;
  if (stage().kind != StageKind::Settle) recorded_.push_back({stage_, {}});
  return {};
}

void Measurement::add(const servo::TickRecord& record) {
  if (state_ != State::Runs || record.revision < revision_) return;
  if ((record.input & servo::kHadSample) == 0U) return;  // the gap shows in the times
  if (begun_ns_ < 0) begun_ns_ = record.time_ns;
  stage_s_ = kSecondPerNanosecond * static_cast<double>(record.time_ns - begun_ns_);
  if (stage().kind != StageKind::Settle) recorded_.back().rows.push_back(rowOf(record));
}

Problems Measurement::advance() {
  if (state_ != State::Runs || stage_s_ < stage().seconds) return {};
  before_s_ += stage().seconds;
  const HandTask hand = stage().hand;
  if (++stage_ == plan_.stages.size()) {
    state_ = State::Done;
    return {};
  }
  stage_s_ = 0.0;
  if (stage().hand == hand) return begin();
  state_ = State::Asks;
  return {};
}

void Measurement::interrupt(const std::string& why) {
  if (state_ == State::Done || state_ == State::Stopped) return;
  state_ = State::Stopped;
  reason_ = why;
}

Problems Measurement::repeat() {
  if (state_ != State::Stopped) return {};
  reason_.clear();
  while (stage_ > 0 && !stage().is_beginning) before_s_ -= plan_.stages[--stage_].seconds;
  std::erase_if(recorded_, [this](const Recorded& one) { return one.stage >= stage_; });
  return begin();
}

Sentence promptOf(HandTask hand) {
  switch (hand) {
    case HandTask::Presses:
      return phrase(TRANSLATE_NOOP("problem",
                                   "Hold the stylus. Press it down slowly by 3 mm and let it come back just as slowly, "
                                   "four times, two seconds each."));
    case HandTask::Turns:
      return phrase(TRANSLATE_NOOP(
          "problem", "Slowly turn the stylus about its own axis in your fingers, and tilt it both ways."));
    case HandTask::LetsGo:
      break;
  }
  return phrase(TRANSLATE_NOOP(
      "problem", "Let go of the stylus and keep your hand away. The arm moves by itself, 20 mm to each side."));
}

Sentence titleOf(const Stage& stage) {
  switch (stage.kind) {
    case StageKind::Settle:
      return phrase(stage.hand == HandTask::LetsGo ? TRANSLATE_NOOP("problem", "The tip moves to its position")
                                                   : TRANSLATE_NOOP("problem", "The hand grips the stylus"));
    case StageKind::Swing:
      return phrase(TRANSLATE_NOOP("problem", "Swings along %1"), {std::string(1, "xyz"[stage.axis])});
    case StageKind::Rest:
      return phrase(TRANSLATE_NOOP("problem", "At rest"));
    case StageKind::Press:
      return phrase(TRANSLATE_NOOP("problem", "Slow press"));
    case StageKind::Turn:
      break;
  }
  return phrase(TRANSLATE_NOOP("problem", "Rotations of the stylus"));
}

}  // namespace underact::identify
