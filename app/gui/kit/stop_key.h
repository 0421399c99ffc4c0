#pragma once
#include <QObject>
#include <functional>

namespace underact::gui {

/// Esc stops the servo wherever the focus is: in a number, an open menu or a dialog. It also closes the menu or dialog.
class StopKey : public QObject {
  Q_OBJECT
 public:
  StopKey(std::function<void()> stop, QObject* parent);
  ~StopKey() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::function<void()> stop_;
};

}  // namespace underact::gui
