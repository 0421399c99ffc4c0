#include "app/gui/kit/flat_forms.h"

#include <algorithm>

#include "app/gui/kit/contrast.h"
#include "app/gui/kit/theme.h"

namespace underact::gui {
namespace {

constexpr double kButtonRadius = 4.0, kBoxRadius = 3.0, kGroove = 4.0;
constexpr double kScrollMargin = 3.0;  // of a scroll bar's handle

bool isOn(const QStyleOption& option, QStyle::StateFlag flag) {
  return option.state.testFlag(flag);
}

QColor towardsText(const QStyleOption& option, QPalette::ColorRole role, double share) {
  return mixed(option.palette.color(role), option.palette.color(QPalette::WindowText), share);
}

/// The colour of what is chosen; grey where it is disabled.
QColor chosenColour(const QStyleOption& option) {
  return isOn(option, QStyle::State_Enabled) ? focusColour(option.palette) : towardsText(option, QPalette::Window, 0.3);
}

}  // namespace

QPen outlinePen(const QStyleOption& option) {
  QColor line = outlineColour(option.palette);
  if (!isOn(option, QStyle::State_Enabled)) line = mixed(option.palette.color(QPalette::Window), line, 0.5);
  return QPen(line, 1.0);
}

void drawFlatButton(const QStyleOptionButton& option, QPainter& painter) {
  const bool is_enabled = isOn(option, QStyle::State_Enabled);
  const bool is_down = isOn(option, QStyle::State_Sunken) || isOn(option, QStyle::State_On);
  QColor ground = option.palette.color(is_enabled ? QPalette::Button : QPalette::Window);
  if (is_enabled && option.features.testFlag(QStyleOptionButton::DefaultButton))
    ground = mixed(ground, option.palette.color(QPalette::Highlight), 0.18);
  if (is_enabled && isOn(option, QStyle::State_MouseOver))
    ground = mixed(ground, option.palette.color(QPalette::WindowText), 0.06);
  if (is_down) ground = mixed(ground, option.palette.color(QPalette::WindowText), 0.14);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(outlinePen(option));
  painter.setBrush(ground);
  painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kButtonRadius, kButtonRadius);
  painter.restore();
}

void drawCheckBox(const QStyleOption& option, QPainter& painter) {
  const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  const bool is_ticked = isOn(option, QStyle::State_On), is_partly = isOn(option, QStyle::State_NoChange);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (is_ticked || is_partly) {
    const QColor chosen = chosenColour(option);
    painter.setPen(QPen(chosen, 1.0));
    painter.setBrush(chosen);
    painter.drawRoundedRect(box, kBoxRadius, kBoxRadius);
    const QColor white = option.palette.color(QPalette::HighlightedText), ground = option.palette.color(QPalette::Base);
    const QColor mark = contrastOf(white, chosen) > contrastOf(ground, chosen) ? white : ground;
    painter.setPen(QPen(mark, std::max(1.6, 0.13 * box.width()), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    const auto at = [&](double x, double y) {
      return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    if (is_ticked) {
      painter.drawPolyline(QPolygonF{at(0.22, 0.54), at(0.42, 0.74), at(0.78, 0.28)});
    } else {
      painter.drawLine(at(0.25, 0.5), at(0.75, 0.5));
    }
  } else {
    painter.setPen(outlinePen(option));
    painter.setBrush(isOn(option, QStyle::State_Sunken) ? towardsText(option, QPalette::Base, 0.14)
                                                        : option.palette.color(QPalette::Base));
    painter.drawRoundedRect(box, kBoxRadius, kBoxRadius);
  }
  painter.restore();
}

void drawSlider(const QStyleOptionSlider& option, const QRect& groove, const QRect& handle, QPainter& painter) {
  const bool is_across = option.orientation == Qt::Horizontal;
  const QPointF middle = QRectF(handle).center();
  QRectF track = groove;
  if (is_across) {
    track = QRectF(track.left(), middle.y() - 0.5 * kGroove, track.width(), kGroove);
  } else {
    track = QRectF(middle.x() - 0.5 * kGroove, track.top(), kGroove, track.height());
  }
  QRectF filled = track;  // from the least value to the handle
  if (is_across) {
    (option.upsideDown ? filled.setLeft(middle.x()) : filled.setRight(middle.x()));
  } else {
    (option.upsideDown ? filled.setTop(middle.y()) : filled.setBottom(middle.y()));
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(towardsText(option, QPalette::Window, 0.22));
  painter.drawRoundedRect(track, 0.5 * kGroove, 0.5 * kGroove);
  painter.setBrush(chosenColour(option));
  painter.drawRoundedRect(filled, 0.5 * kGroove, 0.5 * kGroove);
  const bool is_moved =
      isOn(option, QStyle::State_Sunken) && option.activeSubControls.testFlag(QStyle::SC_SliderHandle);
  const double radius = 0.5 * std::min(handle.width(), handle.height()) - 1.0;
  painter.setPen(isOn(option, QStyle::State_Enabled) ? QPen(chosenColour(option), 1.5) : outlinePen(option));
  painter.setBrush(is_moved
                       ? chosenColour(option)
                       : option.palette.color(isOn(option, QStyle::State_Enabled) ? QPalette::Base : QPalette::Window));
  painter.drawEllipse(middle, radius, radius);
  painter.restore();
}

void drawScrollBar(const QStyleOptionSlider& option, const QRect& handle, QPainter& painter) {
  painter.fillRect(option.rect, option.palette.color(QPalette::Window));
  if (option.maximum <= option.minimum) return;
  const bool is_touched = isOn(option, QStyle::State_MouseOver) || isOn(option, QStyle::State_Sunken);
  const QRectF inner = QRectF(handle).adjusted(kScrollMargin, kScrollMargin, -kScrollMargin, -kScrollMargin);
  const double radius = 0.5 * std::min(inner.width(), inner.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QColor line = outlineColour(option.palette);
  painter.setBrush(is_touched ? mixed(line, option.palette.color(QPalette::WindowText), 0.35) : line);
  painter.drawRoundedRect(inner, radius, radius);
  painter.restore();
}

QRect partOfScrollBar(const QStyleOptionSlider& option, QStyle::SubControl part, int min_handle) {
  const bool is_across = option.orientation == Qt::Horizontal;
  const QRect& all = option.rect;
  const int length = is_across ? all.width() : all.height();
  int handle = length, from = 0;
  if (option.maximum > option.minimum) {
    const qint64 range = qint64{option.maximum} - option.minimum;
    handle = static_cast<int>(qint64{option.pageStep} * length / (range + option.pageStep));
    handle = std::min(std::max(handle, min_handle), length);
    from = QStyle::sliderPositionFromValue(option.minimum, option.maximum, option.sliderPosition, length - handle,
                                           option.upsideDown);
  }
  const auto along = [&](int begin, int end) {
    const QRect place = is_across ? QRect(all.left() + begin, all.top(), end - begin, all.height())
                                  : QRect(all.left(), all.top() + begin, all.width(), end - begin);
    return QStyle::visualRect(option.direction, all, place);
  };
  switch (part) {
    case QStyle::SC_ScrollBarSubPage:
      return along(0, from);
    case QStyle::SC_ScrollBarAddPage:
      return along(from + handle, length);
    case QStyle::SC_ScrollBarSlider:
      return along(from, from + handle);
    case QStyle::SC_ScrollBarGroove:
      return all;
    default:
      return {};  // no buttons
  }
}

}  // namespace underact::gui
