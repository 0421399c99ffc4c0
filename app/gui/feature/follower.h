#pragma once
#include <QString>

#include "app/gui/kit/theme.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

struct Settings;

/// What follows the servo and the window: the panels, and what else a feature brings. Each gets what it overrides.
class Follower {
 public:
  virtual ~Follower() = default;
  virtual void before() {}                         // each frame, before its ticks come
  virtual void add(const servo::TickRecord&) {}    // every tick, in order
  virtual void present(const servo::Snapshot&) {}  // each frame that somebody sees
  virtual void look(const servo::Snapshot&) {}     // each frame, after it was shown: a scene may be put into effect
  virtual void setTheme(const Theme&) {}
  /// Why the arm cannot be given to somebody else now, in a sentence with the way out; empty: it can.
  virtual QString whyBusy() const { return {}; }
  virtual bool mayClose() const { return true; }
  /// The window is about to close: what a person is asked about and what is remembered is the person's own.
  virtual void leave() {}
  /// The window closes: what runs ends in order.
  virtual void finish() {}
  virtual void remember(Settings&) {}
};

}  // namespace underact::gui
