#pragma once
#include <QObject>
#include <functional>

namespace underact::gui {

/// Esc stops, wherever the focus is: in a number, with a menu open, in a dialog. It still closes menu and dialog, too.
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
