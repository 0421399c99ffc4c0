#include "app/gui/window/window_watch.h"

#include <QScreen>
#include <QWidget>
#include <chrono>
#include <cmath>
#include <thread>

#include "app/gui/arms/second_arm.h"
#include "app/gui/kit/stop_key.h"
#include "core/servo/host.h"

namespace underact::gui {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kBeat{50}, kLook{2};
constexpr int kLooks = 20;

/// Where it is on the screen, in the screen's own pixels.
QRect placeOf(const QWidget& widget) {
  if (!widget.isVisible()) return {};
  const QPoint origin = widget.screen()->geometry().topLeft();
  const double scale = widget.devicePixelRatioF();
  const QPoint from_origin = widget.mapToGlobal(QPoint(0, 0)) - origin;
  return {origin + QPoint(static_cast<int>(std::lround(scale * from_origin.x())),
                          static_cast<int>(std::lround(scale * from_origin.y()))),
          scale * widget.size()};
}

}  // namespace

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
const double WindowWatch::kLimit_s = 20.0;
#else
const double WindowWatch::kLimit_s = 0.5;
#endif

WindowWatch::WindowWatch(servo::Host& host, SecondArm& second, const StopKey& key, QWidget* stop_button, double limit_s,
                         QObject* parent)
    : QObject(parent), host_(host), second_(second), key_(key), stop_button_(stop_button) {
  connect(&beat_, &QTimer::timeout, this, &WindowWatch::turn);
  beat_.start(kBeat);
  const auto stalled = [this](std::int64_t pause_ns) {
    if (turns_ == 0) return;  // the window is being made
    host_.reportBusyWindow(pause_ns);
    second_.reportBusyWindow(pause_ns);
  };
  watchdog_ = std::make_unique<servo::Watchdog>([this] { return turns_.load(); },
                                                static_cast<std::int64_t>(1e9 * limit_s), stalled);
  ear_ = StopEar::listen([this](const StopEar::Press& press) { hear(press); });
}

WindowWatch::~WindowWatch() = default;

void WindowWatch::turn() {
  always_stops_ = key_.always();
  stops_ = key_.wouldStop();
  ++turns_;
  if (stop_button_ == nullptr) return;
  const QRect place_px = placeOf(*stop_button_);
  const std::scoped_lock lock(mutex_);
  button_px_ = place_px;
}

/// From the ear's thread.
void WindowWatch::hear(const StopEar::Press& press) {
  if (!press.is_key) {
    const std::scoped_lock lock(mutex_);
    if (button_px_.contains(press.at_px)) stop();
    return;
  }
  if (press.is_shift || always_stops_) return stop();
  // A window's thread that answers has the key, too, and knows best what it is for.
  const std::int64_t before = answers_;
  QMetaObject::invokeMethod(
      this, [this] { ++answers_; }, Qt::QueuedConnection);
  for (int look = 0; look < kLooks && answers_ == before; ++look) std::this_thread::sleep_for(kLook);
  if (answers_ == before && stops_) stop();
}

void WindowWatch::stop() {
  ++host_.stops();
  second_.stopFromAnyThread();
}

}  // namespace underact::gui
