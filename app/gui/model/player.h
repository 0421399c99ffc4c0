#pragma once
#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/model/comparison.h"
#include "app/gui/model/plot_history.h"
#include "app/gui/model/session_load.h"
#include "core/servo/host.h"
#include "device/replayed_arm.h"

namespace underact::gui {

class Document;

/// A recorded session in the window: reads it, plays it on the replayed arm, and shows the recording's scene in the
/// window, unless the user tries another one (what-if).
class Player : public QObject {
  Q_OBJECT
 public:
  /// arm: the host's device; null: nothing can be replayed.
  Player(servo::Host& host, Document& document, device::ReplayedArm* arm, PrepareScene prepare, QObject* parent);
  ~Player() override;

  /// Starts to read a session; opened() or failed() follows. false: the arm cannot replay.
  bool open(const QString& path);
  /// The session opened last, successfully or not; empty: none.
  QString path() const { return path_; }
  bool isLoading() const { return load_ != nullptr; }
  double share() const { return load_ ? load_->share() : 1.0; }
  void cancelLoading();
  /// Restores the previous scene and arm.
  void close();
  bool isOpen() const { return session_.recorded != nullptr; }
  const device::Recorded& recorded() const { return *session_.recorded; }  // only while one is open
  const SessionData& data() const { return *session_.data; }
  std::shared_ptr<const SessionData> sharedData() const { return session_.data; }

  // Only while one is open.
  void play();
  void pause();
  bool isPlaying() const { return arm_ != nullptr && arm_->isPlaying(); }
  void seek(std::int64_t row);
  void step(int rows) { seek(row() + rows); }
  std::int64_t row() const { return arm_ != nullptr ? static_cast<std::int64_t>(arm_->row()) : 0; }
  std::int64_t lastRow() const { return static_cast<std::int64_t>(session_.recorded->rows.size()) - 1; }
  double secondsAt(std::int64_t row) const { return static_cast<double>(row) / session_.recorded->rate_hz; }
  void setSpeed(double speed);
  double speed() const { return arm_ != nullptr ? arm_->speed() : 1.0; }
  void setLoop(bool on);
  bool loops() const { return loops_; }
  /// in: where a loop begins, out: where it ends; each moves the other if necessary.
  void setLoopIn(std::int64_t row);
  void setLoopOut(std::int64_t row);
  std::int64_t loopIn() const { return loop_in_; }
  std::int64_t loopOut() const { return loop_out_; }
  /// On: the window's own scene and gains act. Off: the recorded ones; what was tried returns when it is switched on
  /// again.
  void setWhatIf(bool on);
  bool whatIf() const { return what_if_; }
  /// Compares the ticks since the last jump or edit.
  const Comparison& comparison() const { return comparison_; }

  /// Each frame, before the ticks are drained.
  void poll();
  /// Every tick, in order.
  void add(const servo::TickRecord& record);
  /// What was recorded at the tick added last.
  const RecordedBeside& beside() const { return beside_; }

 signals:
  void loading();
  void opened();
  void closed();
  void cancelled();  // reading was cancelled
  void failed(const QString& path, const underact::Problems& problems);
  void whatIfChanged(bool on);
  void changed();  // play, pause, speed, loop

 private:
  void begin(LoadedSession session);
  void followScene();
  void windowEdited();
  void sendToLoop();

  servo::Host& host_;
  Document& document_;
  device::ReplayedArm* arm_;
  PrepareScene prepare_;
  QString path_;  // being read
  std::unique_ptr<Background<Result<LoadedSession>>> load_;
  LoadedSession session_;
  const device::RecordedScene* scene_ = nullptr;  // shown in the window
  std::optional<scene::Description> tried_;       // while what if is off
  bool what_if_ = false, loops_ = false;
  bool is_putting_ = false;                     // the player itself is changing the scene
  bool was_running_ = false, is_held_ = false;  // before the replay: the servo ran; the arm is a real one
  std::int64_t loop_in_ = 0, loop_out_ = 0;
  std::optional<device::ReplayedArm::SampleOrigin> next_;  // of a tick not drained yet
  RecordedBeside beside_;
  Comparison comparison_;
};

}  // namespace underact::gui
