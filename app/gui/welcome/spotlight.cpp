#include "app/gui/welcome/spotlight.h"

#include <QPainter>
#include <QPainterPath>

namespace underact::gui {

constexpr int kLine_px = 4, kAround_px = 2, kRound_px = 8;

namespace {

QPainterPath rounded(const QRectF& rect, double radius_px) {
  QPainterPath path;
  path.addRoundedRect(rect, radius_px, radius_px);
  return path;
}

}  // namespace

Spotlight::Spotlight(const QString& name, QWidget* window) : QWidget(window) {
  setObjectName(name);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setTheme(Theme::light());
  hide();
}

void Spotlight::pointAt(Where where) {
  where_ = std::move(where);
  follow();
}

// Only a part of a scrolled panel is visible; a panel behind another tab lies outside the window.
QRect Spotlight::seenRect(const QWidget& target) {
  if (!target.isVisible()) return {};
  QRect seen(target.mapTo(target.window(), QPoint()), target.size());
  for (const QWidget* above = target.parentWidget(); above != nullptr; above = above->parentWidget()) {
    seen &= QRect(above->mapTo(target.window(), QPoint()), above->size());
    if (above->isWindow()) break;
  }
  return seen;
}

void Spotlight::pointNowhere() {
  where_ = {};
  hide();
}

void Spotlight::follow() {
  const QRect target = where_ ? where_() : QRect();
  setVisible(!target.isEmpty());
  if (target.isEmpty()) return;
  const int out = kLine_px + kAround_px;
  const QRect wanted = target.adjusted(-out, -out, out, out) & parentWidget()->rect();
  if (wanted == geometry() && !mask().isEmpty()) return;
  setGeometry(wanted);
  const QRect inside = rect().adjusted(kLine_px, kLine_px, -kLine_px, -kLine_px);
  const auto region = [](const QRect& of, int radius_px) {
    return QRegion(rounded(of, radius_px).toFillPolygon().toPolygon());
  };
  setMask(region(rect(), kRound_px) - region(inside, kRound_px - kLine_px));  // only the frame
  raise();
}

void Spotlight::setTheme(const Theme& theme) {
  line_ = theme.dark ? theme.orientation : theme.constraint;
  edge_ = theme.background;
  update();
}

void Spotlight::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), line_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(edge_, 2));  // what it frames may be as dark as the line
  painter.drawPath(rounded(rect(), kRound_px));
}

}  // namespace underact::gui
