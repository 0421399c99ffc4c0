#pragma once
#include <QString>

#include "app/gui/kit/theme.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

struct Settings;

/// Whatever follows the servo and the window: panels and other objects of a feature. Each overrides what it needs.
class ServoListener {
 public:
  virtual ~ServoListener() = default;
  virtual void before() {}                         // each frame, before its ticks
  virtual void add(const servo::TickRecord&) {}    // every tick, in order
  virtual void present(const servo::Snapshot&) {}  // each visible frame
  virtual void poll(const servo::Snapshot&) {}     // each frame, after it was shown; may put a scene into effect
  virtual void setTheme(const Theme&) {}
  /// Why the arm is in use by this object, in a sentence with the way out; empty: it is free.
  virtual QString busyReason() const { return {}; }
  virtual bool mayClose() const { return true; }
  /// The window is about to close: restores the user's own state, which is then saved or asked about.
  virtual void leave() {}
  /// The window closes: ends what is running, in order.
  virtual void finish() {}
  virtual void remember(Settings&) {}
};

}  // namespace underact::gui
