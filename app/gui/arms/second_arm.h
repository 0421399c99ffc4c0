#pragma once
#include <QObject>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "app/gui/model/arm_choice.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_loading.h"
#include "app/gui/model/servo_facts.h"
#include "app/gui/model/simulated_host.h"

namespace underact::gui {

class SceneView;

/// A second arm beside the first, with its own servo, gate and scene, in the same view. It starts and stops with the
/// first: there is one Stop. A simulated one mirrors the first hand.
class SecondArm : public QObject {
  Q_OBJECT
 public:
  enum class Side { Left, Right };

  /// first: the servo of the first arm. first_arms: the choice of that arm.
  SecondArm(ServoFacts first, ArmChoice& first_arms, SceneView& view, QObject* parent);
  ~SecondArm() override;

  bool isOn() const { return simulated_.host != nullptr; }
  void setOn(bool on);
  /// Whether it is on and can push somebody.
  bool isReal() const { return isOn() && arms_->simulated() == nullptr; }
  /// Opens that arm in place of the current one. Problems: why not. Only while it is on.
  Problems choose(const QString& name);
  /// Loads the scene of that file; changed() or told() follows. Also possible before it is on.
  void openScene(const QString& path);
  void setSide(Side side);
  /// The pose of its frame W in that of the first arm, m, if both arms are registered; none: at the side.
  void setPlace(const std::optional<Pose>& X_WS);
  const std::optional<Pose>& placed() const { return X_WS_; }
  /// The listener to each of its ticks; empty: none.
  void setListener(std::function<void(const servo::TickRecord&)> listener) { listener_ = std::move(listener); }
  void setMirrors(bool on) { mirrors_ = on; }
  const QString& scenePath() const { return path_; }
  Side side() const { return side_; }
  bool mirrors() const { return mirrors_; }
  bool isLoading() const { return loading_.isLoading(); }

  void start();
  void stop();
  // Any thread, also while this one is busy or turns it off: servo::Host::stops() and reportBusyWindow() of its servo.
  void stopFromAnyThread();
  void reportBusyWindow(std::int64_t pause_ns);
  void setRate(int rate_hz);
  /// Called each frame.
  void poll();

  // Only while it is on.
  ServoFacts servo() const { return *simulated_.host; }
  void run(std::int64_t ticks) { simulated_.host->run(ticks); }  // with an external clock
  ArmChoice& arms() { return *arms_; }
  device::SimulatedArm& simulatedArm() { return *simulated_.arm; }

 signals:
  void changed();
  /// A message for the user: a fault, a scene or an arm that was refused.
  void told(const QString& sentence);

 private:
  void place();
  void begin();
  void end();
  void setReached(bool on);
  void takeScene();
  void takeFaults();
  void moveHand();

  ServoFacts first_;
  ArmChoice& first_arms_;
  SceneView& view_;
  SimulatedHost simulated_;
  std::mutex mutex_;         // of the next line
  bool is_reached_ = false;  // by other threads
  std::unique_ptr<Document> document_;
  std::unique_ptr<ArmChoice> arms_;
  SceneLoading loading_;
  QString path_;
  Side side_ = Side::Right;
  std::optional<Pose> X_WS_;
  std::function<void(const servo::TickRecord&)> listener_;
  bool mirrors_ = true;
};

}  // namespace underact::gui
