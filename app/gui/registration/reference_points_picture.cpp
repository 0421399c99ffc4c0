#include "app/gui/registration/reference_points_picture.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/registration/sheet.h"

namespace underact::gui {
namespace {

constexpr double kRoom_px = 32.0, kRing_px = 7.0;
constexpr double kEnlarged = 20.0;  // makes a residual of a millimetre visible

QPointF flat_mm(const Vec3& p_D) {
  return kMillimetrePerMetre * QPointF(registration::rightOf(p_D), -registration::awayOf(p_D));
}

}  // namespace

ReferencePointsPicture::ReferencePointsPicture(const QString& object_name, QWidget* parent)
    : Painted(object_name, tr("The reference points on the desk, from above"), {}, parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  present({}, {});
}

void ReferencePointsPicture::present(std::vector<ShownPoint> marks, std::optional<std::size_t> due) {
  marks_ = std::move(marks);
  due_ = due;
  setAccessibleDescription(due ? tr("Next: reference point %1 of %2.").arg(*due + 1).arg(marks_.size())
                               : tr("%1 reference points.").arg(marks_.size()));
  update();
}

void ReferencePointsPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_.background);
  if (marks_.empty()) return;
  QPointF min = flat_mm(marks_.front().p_D), max = min;
  for (const ShownPoint& mark : marks_) {
    const QPointF at = flat_mm(mark.p_D);
    min = {std::min(min.x(), at.x()), std::min(min.y(), at.y())};
    max = {std::max(max.x(), at.x()), std::max(max.y(), at.y())};
  }
  const QPointF span = max - min;
  const double scale = std::min((width() - 2.0 * kRoom_px) / std::max(span.x(), 1.0),
                                (height() - 2.0 * kRoom_px) / std::max(span.y(), 1.0));
  const QPointF middle = 0.5 * (min + max), center(0.5 * width(), 0.5 * height());
  const auto place = [&](const Vec3& p_D) { return center + scale * (flat_mm(p_D) - middle); };
  const QColor grey = mixed(theme_.background, theme_.ink, 0.5);
  painter.setPen(mixed(theme_.quiet, theme_.ink, 0.55));
  painter.drawText(rect().adjusted(4, 2, -4, -2), Qt::AlignTop | Qt::AlignHCenter, tr("away from you"));
  for (std::size_t at = 0; at < marks_.size(); ++at) {
    const ShownPoint& mark = marks_[at];
    const QPointF here = place(mark.p_D);
    const bool is_due = due_ == at;
    const QColor colour = is_due ? theme_.constraint : mark.touched ? theme_.target : grey;
    painter.setPen(QPen(colour, is_due ? 3.0 : 1.5));
    painter.setBrush(mark.touched ? QBrush(mixed(theme_.background, theme_.target, 0.35)) : QBrush(Qt::NoBrush));
    painter.drawEllipse(here, kRing_px, kRing_px);
    painter.drawLine(here - QPointF(kRing_px, 0), here + QPointF(kRing_px, 0));
    painter.drawLine(here - QPointF(0, kRing_px), here + QPointF(0, kRing_px));
    painter.setPen(theme_.ink);
    QFont font = this->font();
    font.setBold(is_due);
    painter.setFont(font);
    painter.drawText(here + QPointF(kRing_px + 4.0, kRing_px + 10.0), QString::number(at + 1));
    paintOff(painter, mark, here, scale);
  }
}

void ReferencePointsPicture::paintOff(QPainter& painter, const ShownPoint& mark, const QPointF& at,
                                      double scale) const {
  if (!mark.off_D) return;
  QPointF offset = scale * kEnlarged * flat_mm(*mark.off_D);
  const double length = std::hypot(offset.x(), offset.y()), max = 0.4 * std::min(width(), height());
  if (length > max) offset *= max / length;
  painter.setPen(QPen(theme_.force, 2.0));
  painter.drawLine(at, at + offset);
  painter.setBrush(theme_.force);
  painter.drawEllipse(at + offset, 2.5, 2.5);
}

}  // namespace underact::gui
