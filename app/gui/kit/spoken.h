#pragma once
#include <QAccessible>

class QWidget;

namespace underact::gui {

/// Has screen readers told what Qt's own answers leave out: the words of a label that has a name of its own ("Force:
/// force 0.31 / 0.88 N"), also when they change, at most twice a second; and that the charts, bars and the view are
/// pictures, no empty panes. Once for the program; asks nothing of the widgets. Costs nothing where nobody reads.
void speakOwnWidgets();

/// That a widget which paints itself is a chart, a graphic or a canvas. To be called before anybody reads it.
void speakAs(QWidget* widget, QAccessible::Role role);

}  // namespace underact::gui
