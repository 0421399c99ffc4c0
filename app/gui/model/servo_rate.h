#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "core/servo/host.h"

namespace underact::gui {

/// Interval between two measurements of the tick rate, in wall-clock time.
inline constexpr qint64 kMeasureEvery_ms = 500;

/// The servo rate of the window: all changes are made here, and whatever shows or uses the rate listens here.
class ServoRate : public QObject {
  Q_OBJECT
 public:
  explicit ServoRate(servo::Host& host, QObject* parent) : QObject(parent), host_(host) {}
  int hz() const { return host_.rateHz(); }
  /// Sets the rate temporarily, as for a measurement or a comparison. Problems: see servo::Host::setRate().
  Problems tryOut(int rate_hz);
  /// Sets the rate permanently: the next start uses it.
  Problems choose(int rate_hz);
  /// The rate chosen since the window was opened.
  std::optional<int> chosen() const { return chosen_; }

 signals:
  void changed(int was_hz, int is_hz);

 private:
  servo::Host& host_;
  std::optional<int> chosen_;
};

/// "real time: FIFO 80"
QString schedulingText(const system::Scheduling& scheduling);

}  // namespace underact::gui
