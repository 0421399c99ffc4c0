#include "app/gui/kit/fit_screen.h"

#include <QScreen>
#include <QWindow>

namespace underact::gui {

QRect fitted(const QRect& window, const QRect& available, const QMargins& frame) {
  const QRect room = available.marginsRemoved(frame);
  QRect fits(window.topLeft(), window.size().boundedTo(room.size()));
  fits.moveBottomRight({qMin(fits.right(), room.right()), qMin(fits.bottom(), room.bottom())});
  fits.moveTopLeft({qMax(fits.left(), room.left()), qMax(fits.top(), room.top())});
  return fits;
}

void fitToScreen(QWidget& window) {
  const bool has_frame = window.windowType() == Qt::Window || window.windowType() == Qt::Dialog;
  if (!has_frame || window.testAttribute(Qt::WA_DontShowOnScreen)) return;
  const QMargins known = window.windowHandle() != nullptr ? window.windowHandle()->frameMargins() : QMargins();
  // It is not known before the window was shown once; GNOME's is the largest.
  const QMargins frame = known.isNull() ? QMargins(4, 40, 4, 4) : known;
  const QRect now = window.normalGeometry(), fits = fitted(now, window.screen()->availableGeometry(), frame);
  const QSize min = window.minimumSize().boundedTo(fits.size());
  if (min != window.minimumSize()) window.setMinimumSize(min);
  const bool is_placed = window.testAttribute(Qt::WA_Moved);
  if (is_placed ? fits == now : fits.size() == now.size()) return;
  const Qt::WindowStates state = window.windowState();
  window.setWindowState(state & ~(Qt::WindowMaximized | Qt::WindowFullScreen));
  is_placed ? window.setGeometry(fits) : window.resize(fits.size());
  window.setWindowState(state);
}

}  // namespace underact::gui
