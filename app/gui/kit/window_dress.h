#pragma once
#include <QByteArray>
#include <QMainWindow>

namespace underact::gui {

/// Everything around the view: docks, bars, menus. It can be hidden for a while and restored.
class WindowDress {
 public:
  enum class Keep { MenusAndTools, Nothing };

  explicit WindowDress(QMainWindow* window) : window_(window) {}
  void takeOff(Keep keep);
  void putOn();
  bool isOff() const { return is_off_; }

 private:
  QMainWindow* window_;
  QByteArray layout_;
  bool had_menus_ = true, had_status_ = true, is_off_ = false;
};

}  // namespace underact::gui
