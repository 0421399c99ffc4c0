#pragma once
#include <QWheelEvent>

namespace underact::gui {

/// A slider, number or chooser on which the wheel scrolls the panel until it has the focus: scrolling past it must not
/// change what a hand feels.
template <class Widget>
class FocusWheel : public Widget {
 public:
  using Widget::Widget;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (Widget::hasFocus())
      Widget::wheelEvent(event);
    else
      event->ignore();
  }
};

}  // namespace underact::gui
