#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/identify/plan.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// The rows of a stage, in order.
struct Recorded {
  std::size_t stage = 0;  // index into Plan::stages
  std::vector<MotionRow> rows;
};

/// Runs a plan on a servo that the caller drives: it puts each scene into effect in turn and keeps the ticks. Time is
/// that of the samples, so the same code measures a real arm and a simulation that runs faster than real time.
class Measurement {
 public:
  /// Puts a scene into effect, as servo::Host::edit does; gives the revision that it will have.
  using Put = std::function<Result<std::uint64_t>(const scene::Description& scene)>;
  /// Asks: the hand has to do something else first; go() says that it does. Stopped: interrupt() was called, and
  /// repeat() continues. Done: recorded() is complete.
  enum class State : std::uint8_t { Asks, Runs, Stopped, Done };

  /// plan: of makePlan(), one stage at least. put: called by go(), advance() and repeat(), on their thread.
  Measurement(Plan plan, Put put);

  /// Where the measurement stands.
  State state() const { return state_; }
  /// The stage that runs, or is next; when all are done, the last one.
  const Stage& stage() const { return plan_.stages[stage_ < plan_.stages.size() ? stage_ : stage_ - 1]; }
  double stageSeconds() const { return stage_s_; }  // since the stage began
  double share() const;                             // that is done, 0 to 1
  const Plan& plan() const { return plan_; }
  const std::vector<Recorded>& recorded() const { return recorded_; }
  /// Why it was stopped; empty: it was not.
  const std::string& reason() const { return reason_; }

  /// The hand does as stage().hand says. Problems: the scene cannot be run.
  Problems go();
  /// Each tick, in order.
  void add(const servo::TickRecord& record);
  /// To be called often between ticks: puts the next scene into effect when the current stage is over.
  Problems advance();
  /// The servo stopped: the rows of the current part are discarded by repeat(). why: a sentence.
  void interrupt(const std::string& why);
  /// Repeats the interrupted part from its beginning, once the servo runs again.
  Problems repeat();

 private:
  Problems begin();
  Plan plan_;
  Put put_;
  State state_ = State::Asks;
  std::size_t stage_ = 0;
  std::uint64_t revision_ = 0;  // of the stage's scene
  std::int64_t begun_ns_ = -1;  // the first sample under it; below 0: not yet
  double stage_s_ = 0.0;
  double before_s_ = 0.0;  // of the stages that are over
  std::vector<Recorded> recorded_;
  std::string reason_;
};

/// What the hand has to do now, a sentence or two.
Sentence promptOf(HandTask hand);
/// What is measured in a stage: "Swings along x".
Sentence titleOf(const Stage& stage);

}  // namespace underact::identify
