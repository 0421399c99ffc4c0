#include "app/gui/lab/front_chart.h"

#include <algorithm>

#include "app/gui/kit/words.h"
#include "app/gui/lab/lab_words.h"

namespace underact::gui {
namespace {

constexpr double kMinCost_us_per_s = 1e-3,
                 kMinError_mm = 1e-6;  // the place of an exact one: a logarithmic axis has no zero
constexpr double kFrontDot = 3.0, kFrontSquare = 5.0, kFrontRing = 8.0;
constexpr double kFrontRoom = 1.25;
constexpr MarkSheet::Colour kFrontGround{&Theme::ink, 0.0};

QPointF placeOf(const tradeoff::Point& point) {
  return {std::max(point.cost_us_per_s, kMinCost_us_per_s), std::max(point.error_mm, kMinError_mm)};
}

QString spokenOf(const std::vector<tradeoff::Point>& points, const std::optional<std::size_t>& chosen) {
  if (points.empty()) return tr("Nothing has been measured.");
  const auto on_front = std::count_if(points.begin(), points.end(), [](const auto& one) { return one.on_front; });
  return tr("%1 combinations, %2 best trade-offs; %3")
      .arg(points.size())
      .arg(on_front)
      .arg(chosen ? tr("chosen: %1 per second, error %2")
                        .arg(timeText(points[*chosen].cost_us_per_s), lengthText(points[*chosen].error_mm))
                  : tr("none of them is in use"));
}

}  // namespace

MarkChart* frontChart(QWidget* parent) {
  return new MarkChart("panel.lab.chart", tr("Error of the tip's path against processor time"),
                       tr("Every combination of choices for this scene: the processor time per second of tick and "
                          "simulated arm, and the deviation of the tip from its path at 16 kHz, root mean square over "
                          "all hands. A best trade-off is one that no other combination beats in both (Pareto front)."),
                       {14, 14}, parent);
}

MarkSheet frontSheet(const std::vector<tradeoff::Point>& points, const std::optional<std::size_t>& chosen) {
  MarkSheet sheet;
  sheet.spoken = spokenOf(points, chosen);
  if (points.empty()) return sheet;
  sheet.y_title = tr("error of the tip's path");
  sheet.words = {{1, Qt::AlignRight, tr("processor time per second")}};
  sheet.key = tr("○ combination  ● best trade-off  ■ as measured  ◎ chosen");
  sheet.word_lines = sheet.key_lines = 2;
  sheet.widest = "500 µm";
  sheet.marks_grow = true;
  std::vector<double> costs, errors;
  for (const tradeoff::Point& point : points) {
    costs.push_back(placeOf(point).x());
    errors.push_back(placeOf(point).y());
    if (point.on_front) sheet.path.push_back(placeOf(point));
  }
  sheet.x = MarkSheet::around(costs, kFrontRoom);
  sheet.x.text = timeText;
  sheet.y = MarkSheet::around(errors, kFrontRoom);
  sheet.y.text = lengthText;
  sheet.y.lines_a_tick = 1.5;
  sheet.path_line = {&Theme::constraint};
  sheet.path_width = 2.0;
  for (const bool on_front : {false, true}) {  // the front is drawn on top
    const MarkSheet::Colour line =
        on_front ? MarkSheet::Colour{&Theme::constraint} : MarkSheet::Colour{&Theme::ink, 0.55};
    for (const tradeoff::Point& point : points) {
      if (point.on_front == on_front)
        sheet.marks.push_back({placeOf(point), kFrontDot, line, 1.2, on_front ? line : kFrontGround});
    }
  }
  for (const tradeoff::Point& point : points) {
    if (point.is_own)
      sheet.marks.push_back({placeOf(point), kFrontSquare, kFrontGround, 1.0, MarkSheet::Colour{&Theme::target}, true});
  }
  if (chosen) sheet.marks.push_back({placeOf(points[*chosen]), kFrontRing, {&Theme::ink}, 2.0});
  return sheet;
}

}  // namespace underact::gui
