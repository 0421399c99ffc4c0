#pragma once
#include <QFocusFrame>
#include <QPointer>
#include <QProxyStyle>

namespace underact::gui {

/// Qt's Fusion, the one style that takes light and dark from a palette everywhere, with a ring around the keyboard
/// focus that has a contrast of 3:1 or more: Fusion's own is nearly transparent, too dark on a dark background, and
/// missing on lists and texts. Message boxes have icons of the program's own set and room around them, menus an edge
/// that is seen on dark windows, too. Buttons, boxes and sliders are flat, scroll bars slim, docks separated by a thin
/// line.
class FocusStyle : public QProxyStyle {
  Q_OBJECT
 public:
  FocusStyle() : QProxyStyle(QStringLiteral("Fusion")) {}
  void polish(QApplication* application) override;
  void polish(QWidget* widget) override { QProxyStyle::polish(widget); }
  void polish(QPalette& palette) override { QProxyStyle::polish(palette); }
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                       const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* more) const override;
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;

 private:
  void frame(QWidget* focused);
  QPointer<QFocusFrame> frame_;  // around a list or a text; deleted with its parent
};

}  // namespace underact::gui
