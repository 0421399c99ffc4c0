#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/identify/plan.h"
#include "core/identify/swing.h"

namespace underact::identify {

/// What a stage left: its rows, in order.
struct Recorded {
  std::size_t stage = 0;  // index into Plan::stages
  std::vector<Row> rows;
};

/// Runs a plan on a servo that somebody else drives: it says which scene comes next, and keeps the ticks. Time is that
/// of the samples, so the same code measures live and as fast as a simulation goes.
class Measurement {
 public:
  /// Puts a scene into effect, as servo::Host::edit does; gives the revision that it will have.
  using Put = std::function<Result<std::uint64_t>(const scene::Description& scene)>;
  /// Asks: the hand has to do something else first; go() says that it does. Runs; Stopped: interrupt() was called, and
  /// repeat() goes on. Done: recorded() is whole.
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
  /// Between two ticks, often: puts the next scene into effect where the last one is over.
  Problems advance();
  /// The servo stopped: what this part of the measurement has kept is of no use. why: a sentence.
  void interrupt(const std::string& why);
  /// Goes on with the part that was stopped, from its beginning; the servo runs again.
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
Sentence promptOf(HandDoes hand);
/// What is measured in a stage: "Swings along x".
Sentence titleOf(const Stage& stage);

}  // namespace underact::identify
