#pragma once
#include <QObject>
#include <QString>
#include <memory>
#include <optional>

#include "app/gui/identify/swing_picture.h"
#include "app/gui/kit/background.h"
#include "app/gui/model/servo_facts.h"
#include "core/identify/report.h"
#include "device/simulated_person.h"

namespace underact::gui {

class ArmChoice;
class ArmInUse;
class Document;
class Player;
class SceneView;

/// The parts of the window that a measurement of the arm uses.
struct IdentifyParts {
  ServoFacts servo;
  ServoControl control;
  Document& document;
  SceneView& view;
  Player& player;
  ArmInUse& in_use;
  ArmChoice& arms;
};

/// A measurement of the arm. Its scenes are tried out in place of the document's. However it ends, it restores what it
/// changed itself: scene, servo and hand. Changes made by others in the meantime are kept.
class IdentifyRun : public QObject {
  Q_OBJECT
 public:
  /// Asks: the hand has to do something, then resume(). Stopped: by a fault or a person; repeat() continues. Evaluates:
  /// everything is recorded. Done: found() is available. Failed: why() says why there is no result; begin() again.
  enum class State { Idle, Asks, Runs, Stopped, Evaluates, Done, Failed };

  IdentifyRun(const IdentifyParts& parts, QObject* parent);
  ~IdentifyRun() override;

  /// Replaces a measurement that is under way. Problems: why it cannot begin.
  Problems begin(identify::Wanted wanted);
  // Both repeat the checks of begin(); if one fails, the measurement stops and why() says so.
  void resume();
  void repeat();
  /// Discards the measurement.
  void cancel();
  void add(const servo::TickRecord& record);
  /// Called each frame. It may put a scene into effect, which invalidates the host's snapshot.
  void poll(const servo::Snapshot& snapshot);

  State state() const { return state_; }
  bool isRunning() const { return measurement_.has_value(); }
  double share() const { return measurement_ ? measurement_->share() : state_ == State::Done ? 1.0 : 0.0; }
  /// The current part of the measurement, and what the hand has to do.
  QString stage() const;
  QString prompt() const;
  /// Why it was stopped, or failed.
  const QString& why() const { return why_; }
  const identify::Identified& found() const { return *found_; }
  /// The true values of the simulated arm; none for a real one.
  const std::optional<identify::Given>& given() const { return given_; }
  bool hasSimulatedPerson() const;
  /// The swings along the current axis, with the fit so far.
  SwingPicture picture() const;

 signals:
  void changed();     // of state or stage
  void progressed();  // each frame while it runs

 private:
  struct LiveFit {
    std::size_t first = 0;  // of the axis' stages
    std::vector<SwingPoint> points;
  };
  void setState(State state, const QString& why = {});
  Result<std::uint64_t> put(const scene::Description& scene);
  void startServo();
  void stopped(const QString& why);
  void end(const QString& why);
  Problems refusalNow() const;
  QString stopReason(const servo::Snapshot& snapshot) const;
  QString rateRefusal() const;
  bool mayGoOn();
  bool hasOwnScene() const;
  void evaluate();
  void takeEvaluation();
  void release();
  void fitLive();
  std::size_t firstOfAxis() const;

  IdentifyParts parts_;
  State state_ = State::Idle;
  std::optional<identify::Measurement> measurement_;
  std::unique_ptr<device::SimulatedPerson> person_;
  std::unique_ptr<Background<Result<identify::Identified>>> evaluation_;
  std::unique_ptr<Background<LiveFit>> live_;
  LiveFit fit_;
  std::size_t fitted_stages_ = 0;
  std::optional<identify::Identified> found_;
  std::optional<identify::Given> given_;
  std::uint64_t revision_ = 0;
  int rate_hz_ = 0;         // of the servo when the first stage began
  std::int64_t ticks_ = 0;  // of the last frame
  servo::Mode mode_ = servo::Mode::Idle;
  std::int64_t started_ticks_ = 0;  // when the servo was started
  bool has_pushed_ = false;         // and it has run since
  bool is_begun_ = false;           // a stage has been put into effect
  bool was_running_ = false;        // the servo, before the measurement
  bool is_own_start_ = false;       // the servo runs because it was started here
  arm::JointAngles q_rad_{};
  QString why_;
};

}  // namespace underact::gui
