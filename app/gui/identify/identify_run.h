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

/// What a measurement of the arm in the window works with.
struct IdentifyParts {
  ServoFacts servo;
  ServoControl control;
  Document& document;
  SceneView& view;
  Player& player;
  ArmInUse& in_use;
  ArmChoice& arms;
};

/// A measurement of the arm at hand. Its scenes are tried out in the document's place; whatever ends it, what it
/// changed itself is as it was before: scene, servo and hand. What somebody else has changed since is left as it is.
class IdentifyRun : public QObject {
  Q_OBJECT
 public:
  /// Asks: the hand has to do something, then goOn(). Stopped: by a fault or a person; repeat() goes on. Evaluates: all
  /// is recorded. Done: found() is there. Failed: why() says why nothing was found; begin() is the way on.
  enum class State { Idle, Asks, Runs, Stopped, Evaluates, Done, Failed };

  IdentifyRun(const IdentifyParts& parts, QObject* parent);
  ~IdentifyRun() override;

  /// In place of what there is. Problems: why it cannot begin.
  Problems begin(identify::Wanted wanted);
  // What begin() asks is asked again: where it does not hold any more, it stops and says so.
  void goOn();
  void repeat();
  /// Nothing is kept.
  void cancel();
  void add(const servo::TickRecord& record);
  /// Each frame. It may put a scene into effect: the snapshot of the host is no longer there then.
  void look(const servo::Snapshot& snapshot);

  State state() const { return state_; }
  bool isAtWork() const { return measurement_.has_value(); }
  double share() const { return measurement_ ? measurement_->share() : state_ == State::Done ? 1.0 : 0.0; }
  /// What is measured now, and what the hand has to do.
  QString stage() const;
  QString prompt() const;
  /// Why it was stopped, or failed.
  const QString& why() const { return why_; }
  const identify::Identified& found() const { return *found_; }
  /// What the simulated arm is made of; none: it is a real one.
  const std::optional<identify::Given>& given() const { return given_; }
  bool hasSimulatedPerson() const;
  /// The swings along the axis that is measured, with the fit so far.
  SwingPicture picture() const;

 signals:
  void changed();     // of state or stage
  void progressed();  // each frame in which it runs

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
  Problems whyNotNow() const;
  QString whyItStands(const servo::Snapshot& snapshot) const;
  QString whyNotAtThisRate() const;
  bool mayGoOn();
  bool hasOwnScene() const;
  std::string armNow() const;
  void evaluate();
  void takeEvaluation();
  void letGo();
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
  std::int64_t started_ticks_ = 0;  // when the servo was told to push
  bool has_pushed_ = false;         // and it has since
  bool is_begun_ = false;           // a stage has been put into effect
  bool was_running_ = false;        // the servo, before
  bool is_own_start_ = false;       // it runs because it was started here
  arm::JointAngles q_rad_{};
  QString why_;
};

}  // namespace underact::gui
