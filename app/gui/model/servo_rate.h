#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "core/servo/host.h"

namespace underact::gui {

/// Between two looks at how many ticks a second there are, by the clock on the wall.
inline constexpr qint64 kMeasureEvery_ms = 500;

/// The servo's rate while the window is open: whoever changes it does so here, and whoever shows or uses it listens.
class ServoRate : public QObject {
  Q_OBJECT
 public:
  explicit ServoRate(servo::Host& host, QObject* parent) : QObject(parent), host_(host) {}
  int hz() const { return host_.rateHz(); }
  /// For now alone, as a measurement or a comparison does. Problems: see servo::Host::setRate().
  Problems tryOut(int rate_hz);
  /// To stay: the next start of the window begins with it.
  Problems choose(int rate_hz);
  /// What was chosen since the window was opened.
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
