#pragma once
#include <QPoint>
#include <functional>
#include <memory>

namespace underact::gui {

/// Hears Esc and the mouse in this program's windows from a thread of its own, while the window's thread is busy, too.
/// Only under X11, where a second connection to the server gets every key and every click, whoever has the keyboard
/// (raw events of XInput 2.1); all but Esc and the left button are passed over. Wayland gives a program its keys by the
/// one connection of its windows.
class StopEar {
 public:
  struct Press {
    bool is_key = false;    // Esc; else the left button
    bool is_shift = false;  // is held, too
    QPoint at_px;           // of the screen: where the mouse is
  };

  /// heard: called from its thread. Null: this desktop has nothing of the kind.
  static std::unique_ptr<StopEar> listen(std::function<void(const Press&)> heard);
  StopEar() = default;
  StopEar(const StopEar&) = delete;
  StopEar& operator=(const StopEar&) = delete;
  virtual ~StopEar() = default;  // ends the thread, and waits
};

}  // namespace underact::gui
