#include "app/gui/plot/chart.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/number_box.h"
#include "app/gui/plot/plot_range.h"

namespace underact::gui {
namespace {

constexpr double kGap = 8.0;
constexpr double kLabelRoom_px = 56.0;                                        // between two labels on the x axis
constexpr double kLineRoom_px = 26.0;                                         // between two labels on the y axis
constexpr double kSwatch_px = 16.0, kSwatchGap_px = 4.0, kNameGap_px = 12.0;  // of the legend
constexpr double kDash_px = 8.0, kDashGap_px = 5.0;
constexpr double kMaxColumns = 100'000.0;

QString tickText(double value, int decimals) {
  if (std::abs(value) < 1e-9) value = 0.0;
  return localNumber(value, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

QFont smaller(QFont font) {
  if (font.pointSizeF() > 0)
    font.setPointSizeF(0.85 * font.pointSizeF());
  else
    font.setPixelSize(std::max(1, qRound(0.85 * font.pixelSize())));
  return font;
}

QFont boldOf(QFont font) {
  font.setBold(true);
  return font;
}

/// Clips the line from a to b to the box; false: nothing of it is inside. Liang and Barsky, "A new concept and method
/// for line clipping", 1984: the fractions of the line at which it enters and leaves.
bool clipLine(const QRectF& box, QPointF& a, QPointF& b) {
  const QPointF offset = b - a;
  double in = 0.0, out = 1.0;
  for (const auto& [step, room] : {std::pair{-offset.x(), a.x() - box.left()},
                                   {offset.x(), box.right() - a.x()},
                                   {-offset.y(), a.y() - box.top()},
                                   {offset.y(), box.bottom() - a.y()}}) {
    if (step == 0.0 && room < 0.0) return false;
    if (step < 0.0) in = std::max(in, room / step);
    if (step > 0.0) out = std::min(out, room / step);
  }
  if (in > out) return false;
  const QPointF from = a;
  if (out < 1.0) b = from + out * offset;
  if (in > 0.0) a = from + in * offset;
  return true;
}

int decimals(const std::vector<double>& places) {
  return places.size() < 2 ? 1 : decimalsOf(places[1] - places[0]);
}

}  // namespace

Chart::Chart(const QString& title, const QString& x_title, const std::vector<Curve>& curves)
    : title_(title), x_title_(x_title), curves_(curves), points_(curves.size()) {
  reserve(4);
}

void Chart::setColours(const Theme& theme, const std::vector<QColor>& curves) {
  theme_ = theme;
  colours_ = curves;
}

void Chart::setPlace(const QRectF& area, double scale, const QFont& font) {
  default_font_ = font;
  font_ = smaller(font);
  const QFontMetricsF metrics(font_);
  const double left = std::ceil(metrics.horizontalAdvance(QStringLiteral("\u221200.0")) + kGap);
  area_ = area;
  legend_lines_ = left + titleWidth() + legendWidth() + 1.5 * kGap > area.width() ? legendLines() : 0;
  const double top = std::ceil(metrics.height() + 1.5 * kGap), bottom = std::ceil(metrics.height() + 1.25 * kGap);
  axes_ = area.adjusted(left, top, -1.5 * kGap, -bottom);
  if (axes_.width() < 8.0) axes_.setWidth(8.0);
  if (axes_.height() < 8.0) axes_.setHeight(8.0);
  scale_ = scale;
  setTicks();
}

void Chart::setCurveShown(std::size_t curve, bool shown) {
  if (curves_[curve].shown == shown) return;
  curves_[curve].shown = shown;
  setPlace(area_, scale_, default_font_);  // the legend may move below the title, or back
}

std::size_t Chart::columns() const {
  const double enlarged = (whole_.x_to - whole_.x_from) / (x_to_ - x_from_);
  const double all = scale_ * axes_.width() * (std::isfinite(enlarged) ? std::max(enlarged, 1.0) : 1.0);
  return static_cast<std::size_t>(std::clamp(all, 8.0, kMaxColumns));
}

void Chart::setRange(double x_from, double x_to, double y_from, double y_to) {
  whole_ = {x_from, x_to, y_from, y_to};
  show(part_.value_or(whole_));
}

void Chart::showPart(const Part& part) {
  part_ = part;
  show(part);
}

void Chart::showWhole() {
  part_.reset();
  show(whole_);
}

void Chart::show(const Part& part) {
  const auto& [x_from, x_to, y_from, y_to] = part;
  if (part == seen()) return;
  x_from_ = x_from;
  x_to_ = x_to;
  y_from_ = y_from;
  y_to_ = y_to;
  setTicks();
}

void Chart::setTicks() {
  x_ticks_ = ticks(x_from_, x_to_, std::max(2, static_cast<int>(axes_.width() / kLabelRoom_px)));
  const int max = std::max(2, static_cast<int>(axes_.height() / kLineRoom_px));
  y_ticks_ = tick_step_ > 0.0 ? multiples(y_from_, y_to_, tick_step_, max) : ticks(y_from_, y_to_, max);
}

void Chart::reserve(std::size_t count) {
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
    if (points_[curve].size() == count) continue;
    points_[curve].assign(count, {});
  }
}

std::optional<double> Chart::xAt(const QPointF& place) const {
  if (!axes_.contains(place)) return {};
  return x_from_ + (place.x() - axes_.left()) / axes_.width() * (x_to_ - x_from_);
}

QPointF Chart::placeOf(double x) const {
  return {axes_.left() + (x - x_from_) / (x_to_ - x_from_) * axes_.width(), axes_.center().y()};
}

QPointF Chart::placeOf(double x, double y) const {
  return {axes_.left() + (x - x_from_) / (x_to_ - x_from_) * axes_.width(),
          axes_.bottom() - (y - y_from_) / (y_to_ - y_from_) * axes_.height()};
}

void Chart::paint(QPainter& painter) {
  paintGrid(painter);
  painter.save();
  painter.setClipRect(axes_);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
    if (curves_[curve].shown) paintCurve(painter, curve);
  }
  painter.restore();
  paintWords(painter);
}

void Chart::paintGrid(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(mixed(theme_.background, theme_.quiet, 0.4), 1.0));
  for (const double tick : x_ticks_) {
    const double x = placeOf(tick, y_from_).x();
    painter.drawLine(QPointF(x, axes_.top()), QPointF(x, axes_.bottom()));
  }
  for (const double tick : y_ticks_) {
    const double y = placeOf(x_from_, tick).y();
    painter.drawLine(QPointF(axes_.left(), y), QPointF(axes_.right(), y));
  }
  painter.setPen(QPen(theme_.quiet, 1.0));
  painter.drawLine(axes_.bottomLeft(), axes_.topLeft());
  painter.drawLine(axes_.bottomLeft(), axes_.bottomRight());
}

/// Only what lies within the axes is given to the painter, as connected lines: otherwise it would draw the rest, too,
/// dash by dash.
void Chart::paintCurve(QPainter& painter, std::size_t curve) {
  const double width = static_cast<double>(curves_[curve].width);
  QPen pen(colours_[curve], width, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
  if (curves_[curve].dashed) pen.setDashPattern({kDash_px / width, kDashGap_px / width});
  painter.setPen(pen);
  const QRectF box = axes_.adjusted(-width, -width, width, width);
  const auto end = [&] {
    if (line_.size() > 1) painter.drawPolyline(line_.data(), static_cast<int>(line_.size()));
    line_.clear();
  };
  bool has_last = false;
  QPointF last;
  for (const PlotPoint& point : points_[curve]) {
    const QPointF place = placeOf(static_cast<double>(point.x), static_cast<double>(point.y));
    if (!std::isfinite(place.x()) || !std::isfinite(place.y())) {
      end();
      has_last = false;
      continue;
    }
    if (has_last && place != last) {
      QPointF from = last, to = place;
      const bool is_seen = clipLine(box, from, to);
      if (!is_seen || line_.empty() || line_.back() != from) end();
      if (is_seen && line_.empty()) line_.push_back(from);
      if (is_seen) line_.push_back(to);
    }
    last = place;
    has_last = true;
  }
  end();
}

void Chart::paintWords(QPainter& painter) const {
  const QFontMetricsF metrics(font_);
  const QColor quiet = mixed(theme_.quiet, theme_.ink, 0.55);
  painter.setFont(font_);
  painter.setPen(quiet);
  const double base = std::round(axes_.bottom() + kGap * 0.5 + metrics.ascent());
  const double title_width = metrics.horizontalAdvance(x_title_);
  const double free_until = axes_.right() - title_width - kGap;
  for (const double tick : x_ticks_) {
    const QString text = tickText(tick, decimals(x_ticks_));
    const double width = metrics.horizontalAdvance(text);
    const double x = axes_.left() + (tick - x_from_) / (x_to_ - x_from_) * axes_.width() - 0.5 * width;
    if (x + width < free_until) painter.drawText(QPointF(std::round(x), base), text);
  }
  painter.drawText(QPointF(std::round(axes_.right() - title_width), base), x_title_);
  for (const double tick : y_ticks_) {
    const QString text = tickText(tick, decimals(y_ticks_));
    const double y = axes_.bottom() - (tick - y_from_) / (y_to_ - y_from_) * axes_.height();
    painter.drawText(QPointF(std::round(axes_.left() - 0.75 * kGap - metrics.horizontalAdvance(text)),
                             std::round(y + 0.5 * (metrics.ascent() - metrics.descent()))),
                     text);
  }
  const double title_base = std::round(area_.top() + 0.5 * kGap + metrics.ascent());
  paintLegend(painter, title_base);
  painter.setFont(boldOf(font_));
  painter.setPen(theme_.ink);
  // Above its axis; farther left if it is too long.
  const double left = std::clamp(area_.right() - titleWidth() - kGap, area_.left() + kGap, axes_.left());
  const QString title = QFontMetricsF(boldOf(font_)).elidedText(title_, Qt::ElideRight, area_.right() - left);
  painter.drawText(QPointF(std::round(left), title_base), title);
}

/// Beside the title; where there is no room, over the axes at their top right, so that it takes nothing from them.
void Chart::paintLegend(QPainter& painter, double base) const {
  const QFontMetricsF metrics(font_);
  const bool is_over = legend_lines_ > 0;
  double left = axes_.right() - (is_over ? widestName() + 0.5 * kGap : legendWidth());
  if (is_over) {
    base = std::round(axes_.top() + 0.5 * kGap + metrics.ascent());
    const QRectF under(left - 0.5 * kGap, axes_.top() + 2.0, widestName() + kGap,
                       legend_lines_ * std::round(metrics.height()) + 0.5 * kGap);
    painter.fillRect(under & axes_, faint(theme_.background, 0.8));
  }
  painter.setFont(font_);
  painter.setPen(mixed(theme_.quiet, theme_.ink, 0.55));
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
    const double width = nameWidth(curves_[curve]);
    if (width <= 0.0 || (is_over && base > axes_.bottom())) continue;
    const double thick = std::max(1.0, std::round(static_cast<double>(curves_[curve].width)));
    const double top = std::round(base - 0.32 * metrics.ascent() - 0.5 * thick);
    const double dash = curves_[curve].dashed ? 0.4 * kSwatch_px : kSwatch_px;
    for (double at = 0.0; at < kSwatch_px; at += 1.5 * dash) {
      painter.fillRect(QRectF(std::round(left + at), top, std::round(dash), thick), colours_[curve]);
    }
    painter.drawText(QPointF(std::round(left + kSwatch_px + kSwatchGap_px), base), curves_[curve].name);
    if (is_over) {
      base += std::round(metrics.height());
    } else {
      left += width + kNameGap_px;
    }
  }
}

double Chart::widestName() const {
  double width = 0.0;
  for (const Curve& curve : curves_) width = std::max(width, nameWidth(curve));
  return width;
}

/// With its swatch; 0: not in the legend.
double Chart::nameWidth(const Curve& curve) const {
  if (curve.name.isEmpty() || !curve.shown) return 0.0;
  return kSwatch_px + kSwatchGap_px + QFontMetricsF(font_).horizontalAdvance(curve.name);
}

double Chart::legendWidth() const {
  double width = 0.0;
  for (const Curve& curve : curves_) {
    const double name = nameWidth(curve);
    if (name > 0.0) width += name + (width > 0.0 ? kNameGap_px : 0.0);
  }
  return width;
}

int Chart::legendLines() const {
  return static_cast<int>(
      std::count_if(curves_.begin(), curves_.end(), [this](const Curve& curve) { return nameWidth(curve) > 0.0; }));
}

double Chart::titleWidth() const {
  return QFontMetricsF(boldOf(font_)).horizontalAdvance(title_);
}

}  // namespace underact::gui
