#pragma once
#include <QWidget>

namespace underact::gui {

/// Where a window, without its frame, fits with it into what the panels of the desktop leave.
QRect fitted(const QRect& window, const QRect& available, const QMargins& frame);
/// Makes a window or a dialog that is about to be shown, its minimum, too, as small as its screen requires. Of one that
/// is maximised the normal size: where the desktop is slow to say so, Qt takes the maximised one for it.
void fitToScreen(QWidget& window);

}  // namespace underact::gui
