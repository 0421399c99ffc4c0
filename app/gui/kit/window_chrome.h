#pragma once
#include <QByteArray>
#include <QMainWindow>

namespace underact::gui {

/// Everything around the view: docks, bars, menus. It can be hidden for a while and restored.
class WindowChrome {
 public:
  enum class Keep { MenusAndTools, Nothing };

  explicit WindowChrome(QMainWindow* window) : window_(window) {}
  void hideChrome(Keep keep);
  void showChrome();
  bool isOff() const { return is_off_; }

 private:
  QMainWindow* window_;
  QByteArray layout_;
  bool had_menus_ = true, had_status_ = true, is_off_ = false;
};

}  // namespace underact::gui
