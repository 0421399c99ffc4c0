#include "app/gui/window/window_watch.h"

#include <QApplication>
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
constexpr int kTurnsALook = 20;  // for buttons that are new

/// Where it is on the screen, in the screen's own pixels.
QRect placeOf(const QWidget& widget) {
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

WindowWatch::WindowWatch(servo::Host& host, SecondArm& second, const StopKey& key, double limit_s)
    : host_(host), second_(second), key_(key) {
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
  if (turns_++ % kTurnsALook == 0) {
    buttons_.clear();
    for (QWidget* const widget : QApplication::allWidgets())
      if (widget->property(StopKey::kStops).toBool()) buttons_.emplace_back(widget);
  }
  QRegion places_px;
  for (const QPointer<QWidget>& button : buttons_)
    if (button != nullptr && button->isVisible()) places_px += placeOf(*button);
  const std::scoped_lock lock(mutex_);
  buttons_px_ = places_px;
}

/// From the ear's thread.
void WindowWatch::hear(const StopEar::Press& press) {
  if (!press.is_key) {
    const std::scoped_lock lock(mutex_);
    if (buttons_px_.contains(press.at_px)) stop();
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
