#pragma once
#include <QObject>
#include <QPointer>
#include <QRegion>
#include <QTimer>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "app/gui/kit/stop_ear.h"
#include "core/servo/watchdog.h"

class QWidget;

namespace underact::servo {
class Host;
}

namespace underact::gui {

class SecondArm;
class StopKey;

/// Stop, while the window's thread is busy. Esc, Shift+Esc and a click on Stop (StopKey::kStops) are heard by a thread
/// of their own (see StopEar), which waits for the window's only where Esc may be meant for something else, and then 40
/// ms at most. If the window's thread has not turned for a while and a servo pushes, that is a fault.
class WindowWatch : public QObject {
  Q_OBJECT
 public:
  /// How long the window's thread may stand still. Longer under a sanitizer, which makes it slow.
  static const double kLimit_s;

  /// host, second and key outlive it. limit_s: above 0.
  WindowWatch(servo::Host& host, SecondArm& second, const StopKey& key, double limit_s);
  ~WindowWatch() override;
  /// Whether keys are heard while the window's thread is busy.
  bool hears() const { return ear_ != nullptr; }

 private:
  void turn();
  void hear(const StopEar::Press& press);
  void stop();

  servo::Host& host_;
  SecondArm& second_;
  const StopKey& key_;
  std::vector<QPointer<QWidget>> buttons_;
  QTimer beat_;
  // What the other threads know of the window's.
  std::atomic<std::int64_t> turns_{0}, answers_{0};
  std::atomic<bool> always_stops_{true}, stops_{true};
  std::mutex mutex_;  // of the next line
  QRegion buttons_px_;
  std::unique_ptr<servo::Watchdog> watchdog_;
  std::unique_ptr<StopEar> ear_;
};

}  // namespace underact::gui
