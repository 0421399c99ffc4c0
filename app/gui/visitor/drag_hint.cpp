#include "app/gui/visitor/drag_hint.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kRound_ms = 2600, kSide_px = 200;
constexpr double kTakes = 0.2, kStays = 0.85;  // shares of a round: it presses, and it lets go
const QPointF kFrom(60.0, 60.0), kTo(150.0, 120.0);

/// A pointer, its tip at the origin.
QPainterPath pointer() {
  QPainterPath path;
  path.addPolygon(QPolygonF{{{0, 0}, {0, 25}, {6, 19.5}, {10, 28.5}, {14, 26.7}, {10, 18}, {18, 18}, {0, 0}}});
  return path;
}

}  // namespace

DragHint::DragHint(SceneView& view)
    : Painted("visitor.hint", tr("How to begin"), tr("Drag the stylus with the mouse."), &view), view_(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  resize(kSide_px, kSide_px);
  hide();
  progress_.setStartValue(0.0);
  progress_.setEndValue(1.0);
  progress_.setDuration(kRound_ms);
  progress_.setLoopCount(-1);
  connect(&progress_, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
}

void DragHint::present(bool on) {
  if (on) {
    const QRectF stylus = view_.stylusOnScreen();
    if (stylus.isEmpty()) on = false;
    const QPoint corner = (stylus.center() - kFrom).toPoint();
    if (on && pos() != corner && isHidden()) move(corner);  // it does not run after the stylus
  }
  if (on == !isHidden()) return;
  setVisible(on);
  if (!on) return progress_.stop();
  raise();
  progress_.start();
}

void DragHint::paintEvent(QPaintEvent*) {
  const double at = progress_.currentValue().toDouble();
  const double share = std::clamp((at - kTakes) / (kStays - kTakes), 0.0, 1.0);
  const QPointF tip = kFrom + share * share * (3.0 - 2.0 * share) * (kTo - kFrom);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.ink, 2.5, Qt::DotLine, Qt::RoundCap));
  painter.drawLine(kFrom, tip);
  if (at > 0.5 * kTakes && at < kStays) {
    painter.setPen(QPen(theme_.target, 3.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(tip, 11.0, 11.0);
  }
  painter.translate(tip);
  painter.scale(1.4, 1.4);
  painter.setPen(QPen(theme_.background, 1.6));
  painter.setBrush(theme_.ink);
  painter.drawPath(pointer());
}

}  // namespace underact::gui
