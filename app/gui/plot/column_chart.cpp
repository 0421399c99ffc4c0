#include "app/gui/plot/column_chart.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/gui/model/plot_columns.h"
#include "app/gui/plot/plot_range.h"

namespace underact::gui {
namespace {

constexpr double kBeyond = 0.05;  // of the range, above and below the curves

}  // namespace

Chart columnChart(const std::vector<int>& columns) {
  std::vector<Chart::Curve> curves;
  QStringList units;
  for (const int column : columns) {
    const PlotColumn& one = plotColumns()[static_cast<std::size_t>(column)];
    curves.push_back({one.name, 1.5F});
    if (!one.unit.isEmpty() && !units.contains(one.unit)) units << one.unit;
  }
  curves.push_back({QString(), 1.0F});  // the cursor of a replay
  const QString title = units.isEmpty() ? QCoreApplication::translate("columns", "Columns")
                                        : QCoreApplication::translate("columns", "Columns [%1]").arg(units.join(", "));
  Chart chart(title, QCoreApplication::translate("columns", "time [s]"), curves);
  chart.setHelper(curves.size() - 1);
  return chart;
}

void setColumnColours(Chart& chart, const Theme& theme) {
  const std::vector<QColor> palette{theme.constraint, theme.force_limited, theme.target,
                                    theme.position,   theme.force,         theme.orientation};
  std::vector<QColor> colours;
  for (std::size_t curve = 0; curve + 1 < chart.curves(); ++curve) colours.push_back(palette[curve % palette.size()]);
  colours.push_back(theme.ink);
  chart.setColours(theme, colours);
}

void fillColumnChart(Chart& chart, const ColumnRows& rows, double from_s, double to_s, double shift_s) {
  double min = 0.0, greatest = 0.0;
  bool has_one = false;
  for (std::size_t index = 0; index + 1 < chart.curves(); ++index) {
    if (index >= rows.columns().size()) break;
    const std::size_t used = thinColumn(rows, index, chart.columns(), from_s, to_s, shift_s, chart.points(index));
    for (const PlotPoint& point : chart.points(index).first(used)) {
      const auto value = static_cast<double>(point.y);
      min = has_one ? std::min(min, value) : value;
      greatest = has_one ? std::max(greatest, value) : value;
      has_one = true;
    }
  }
  const double span = greatest > min ? greatest - min : std::max(std::abs(greatest), 1.0);
  chart.setRange(from_s + shift_s, to_s + shift_s, min - kBeyond * span, greatest + kBeyond * span);
}

}  // namespace underact::gui
