#include "app/gui/plot/lateness_chart.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

constexpr double kBarsADecade = 5.0, kDecades = 5.0;

/// The upper edge of a bar, us.
double edge_us(std::size_t bar) {
  return std::pow(10.0, static_cast<double>(bar + 1) / kBarsADecade);
}

}  // namespace

LatenessChart::LatenessChart(QWidget* parent)
    : Painted("panel.servo.lateness", tr("Latency histogram"),
              tr("Number of ticks by latency, both scales logarithmic. The line marks one period: ticks to the right "
                 "of it were late."),
              parent) {
  setAccessibleRole(this, QAccessible::Chart);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize LatenessChart::minimumSizeHint() const {
  return {120, 6 * fontMetrics().lineSpacing()};
}

void LatenessChart::present(const servo::Histogram& lateness, double period_us) {
  std::array<std::int64_t, kBars> counts{};
  std::int64_t from_ns = -1;
  for (std::size_t bar = 0; bar < kBars; ++bar) {
    const std::int64_t to_ns =
        bar + 1 < kBars ? static_cast<std::int64_t>(1e3 * edge_us(bar)) : std::numeric_limits<std::int64_t>::max();
    counts[bar] = lateness.between(from_ns, to_ns);
    from_ns = to_ns;
  }
  if (counts == counts_ && period_us == period_us_) return;
  counts_ = counts;
  period_us_ = period_us;
  setAccessibleDescription(
      tr("99 of 100 ticks have a latency of %1 µs or less").arg(numberText(lateness.percentiles().p99_us, 0)));
  update();
}

QRectF LatenessChart::plot() const {
  return {4.0, 4.0, width() - 8.0, height() - fontMetrics().lineSpacing() - 10.0};
}

double LatenessChart::xOf(double lateness_us) const {
  return plot().left() + plot().width() * std::clamp(std::log10(lateness_us) / kDecades, 0.0, 1.0);
}

void LatenessChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF area = plot();
  const std::int64_t max = *std::max_element(counts_.begin(), counts_.end());
  const double highest = std::log10(1.0 + static_cast<double>(std::max<std::int64_t>(max, 9)));
  const double width = area.width() / static_cast<double>(kBars);
  for (std::size_t bar = 0; bar < kBars; ++bar) {
    if (counts_[bar] == 0) continue;
    const double high = std::max(2.0, area.height() * std::log10(1.0 + static_cast<double>(counts_[bar])) / highest);
    const QRectF column(area.left() + width * static_cast<double>(bar) + 0.5, area.bottom() - high, width - 1.0, high);
    const bool late = edge_us(bar) > period_us_ * 1.0001;
    painter.fillRect(column, late ? theme_.force_limited : ink(0.5));
  }
  painter.setPen(QPen(ink(0.5), 1.0));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.setPen(QPen(theme_.ink, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(xOf(period_us_), area.top()), QPointF(xOf(period_us_), area.bottom()));
  painter.setPen(ink(0.75));
  const double line = fontMetrics().lineSpacing();
  const QRectF words(area.left(), area.bottom() + 4.0, area.width(), line);
  painter.drawText(words, Qt::AlignLeft, tr("1 µs"));
  painter.drawText(QRectF(xOf(1000.0) - 40.0, words.top(), 80.0, line), Qt::AlignHCenter, tr("1 ms"));
  painter.drawText(words, Qt::AlignRight, tr("100 ms"));
}

}  // namespace underact::gui
