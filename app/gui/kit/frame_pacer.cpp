#include "app/gui/kit/frame_pacer.h"

#include <QAbstractEventDispatcher>
#include <algorithm>

namespace underact::gui {

constexpr int kFastest_ms = 16;
constexpr int kSlowest_ms = 100;
constexpr int kUnseen_ms = 33;
constexpr double kShareOfTheThread = 0.6;
constexpr double kSmoothing = 0.2;  // weight of a new frame in the average: about five frames

FramePacer::FramePacer(QObject* parent) : QObject(parent), interval_ms_(kFastest_ms) {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  clock_.start();
  connect(&timer_, &QTimer::timeout, this, &FramePacer::next);
  // The time between waking up and waiting again covers all events, panels, view and plots.
  QAbstractEventDispatcher* dispatcher = QAbstractEventDispatcher::instance();
  connect(dispatcher, &QAbstractEventDispatcher::awake, this, [this] { woke_ns_ = clock_.nsecsElapsed(); });
  connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, [this] {
    if (woke_ns_ > 0) busy_ns_ += clock_.nsecsElapsed() - woke_ns_;
    woke_ns_ = 0;
  });
}

void FramePacer::start() {
  timer_.start(interval_ms_);
}

void FramePacer::next() {
  const qint64 now_ns = clock_.nsecsElapsed();
  if (woke_ns_ > 0) {
    busy_ns_ += now_ns - woke_ns_;
    woke_ns_ = now_ns;
  }
  smooth_busy_ms_ += kSmoothing * (1e-6 * static_cast<double>(busy_ns_) - smooth_busy_ms_);
  busy_ns_ = 0;
  const int affordable_ms = static_cast<int>(smooth_busy_ms_ / kShareOfTheThread);
  interval_ms_ = seen_ ? std::clamp(affordable_ms, kFastest_ms, kSlowest_ms) : kUnseen_ms;
  timer_.start(interval_ms_);
  emit frame();
}

}  // namespace underact::gui
