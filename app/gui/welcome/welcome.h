#pragma once
#include <QFrame>
#include <array>
#include <cstdint>
#include <optional>

#include "app/gui/theme.h"
#include "core/arm/sample.h"
#include "core/servo/snapshot.h"

class QLabel;

namespace underact::gui {

class Actions;
class Document;
class Hand;
class SceneView;
class Spotlight;

/// The first minute: a card over the view with three things to try. Each is ticked off when it was done; the card
/// leaves a little later, and comes back only when it is asked for. It stands where the stylus is not.
class Welcome : public QFrame {
  Q_OBJECT
 public:
  /// was_seen: in an earlier life of the window; then it waits to be asked for.
  Welcome(SceneView& view, const Hand& hand, Document& document, Actions& actions, bool was_seen);
  /// Each frame. rate_hz: ticks a second, by which it leaves. may_show false: something else has the window.
  void present(const servo::Snapshot& snapshot, int rate_hz, bool may_show);
  /// Something was done, or it was closed, once: it does not come back unasked.
  bool wasSeen() const { return was_seen_; }
  void setTheme(const Theme& theme);

 private:
  enum Thing { Push, Slider, Turn, kThings };
  void build(Actions& actions);
  void ask();
  void close();
  void tell();
  void done(Thing thing, const QString& sentence);
  void watch(const servo::Snapshot& snapshot);
  void place();

  SceneView& view_;
  const Hand& hand_;
  Document& document_;
  Spotlight* slider_;
  std::array<QLabel*, kThings> rows_{};
  std::array<bool, kThings> is_done_{};
  QLabel* confirmed_;
  bool was_seen_, is_asked_, is_shown_ = false;
  bool edited_ = false;  // since it was asked
  std::optional<arm::JointAngles> began_rad_;
  std::int64_t leaves_at_tick_ = -1;
};

}  // namespace underact::gui
