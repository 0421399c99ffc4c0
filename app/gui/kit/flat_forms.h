#pragma once
#include <QPainter>
#include <QStyle>
#include <QStyleOption>

namespace underact::gui {

// The forms of buttons, boxes, sliders and scroll bars: flat, with an outline of 3:1 against what is around it. Colours
// are those of the option's palette and state.

/// The pen of an outline; paler where the widget is disabled.
QPen outlinePen(const QStyleOption& option);
void drawFlatButton(const QStyleOptionButton& option, QPainter& painter);
void drawCheckBox(const QStyleOption& option, QPainter& painter);
/// groove, handle: as the style places them.
void drawSlider(const QStyleOptionSlider& option, const QRect& groove, const QRect& handle, QPainter& painter);
void drawScrollBar(const QStyleOptionSlider& option, const QRect& handle, QPainter& painter);

/// The parts of a scroll bar without buttons at its ends.
QRect partOfScrollBar(const QStyleOptionSlider& option, QStyle::SubControl part, int min_handle);

}  // namespace underact::gui
