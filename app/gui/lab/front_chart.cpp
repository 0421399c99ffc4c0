#include "app/gui/lab/front_chart.h"

#include <algorithm>

#include "app/gui/kit/words.h"
#include "app/gui/lab/lab_words.h"

namespace underact::gui {
namespace {

constexpr double kLeastCost_us_per_s = 1e-3,
                 kLeastError_mm = 1e-6;  // what is exact stands there: a logarithm has no zero
constexpr double kFrontDot = 3.0, kFrontSquare = 5.0, kFrontRing = 8.0;
constexpr double kFrontRoom = 1.25;
constexpr MarkSheet::Colour kFrontGround{&Theme::ink, 0.0};

QPointF placeOf(const trade::Point& point) {
  return {std::max(point.cost_us_per_s, kLeastCost_us_per_s), std::max(point.error_mm, kLeastError_mm)};
}

QString spokenOf(const std::vector<trade::Point>& points, const std::optional<std::size_t>& chosen) {
  if (points.empty()) return tr("Nothing is measured.");
  const auto on_front = std::count_if(points.begin(), points.end(), [](const auto& one) { return one.on_front; });
  return tr("%1 ways, %2 on the front; %3")
      .arg(points.size())
      .arg(on_front)
      .arg(chosen ? tr("chosen: %1 a second, error %2")
                        .arg(timeText(points[*chosen].cost_us_per_s), lengthText(points[*chosen].error_mm))
                  : tr("none of them is in effect"));
}

}  // namespace

MarkChart* frontChart(QWidget* parent) {
  return new MarkChart(
      "panel.lab.chart", tr("Error of the tip's way against processor time"),
      tr("Every way to run this scene: what a second of it takes, tick and simulated arm, and how far the tip is "
         "off its way at 16 kHz, root of the mean square over all hands. The front is what nothing beats in "
         "both."),
      {14, 14}, parent);
}

MarkSheet frontSheet(const std::vector<trade::Point>& points, const std::optional<std::size_t>& chosen) {
  MarkSheet sheet;
  sheet.spoken = spokenOf(points, chosen);
  if (points.empty()) return sheet;
  sheet.y_title = tr("error of the tip's way");
  sheet.words = {{1, Qt::AlignRight, tr("processor time for a second")}};
  sheet.key = tr("○ a way  ● on the front  ■ as it was  ◎ chosen");
  sheet.word_lines = sheet.key_lines = 2;
  sheet.widest = "500 µm";
  sheet.marks_grow = true;
  std::vector<double> costs, errors;
  for (const trade::Point& point : points) {
    costs.push_back(placeOf(point).x());
    errors.push_back(placeOf(point).y());
    if (point.on_front) sheet.way.push_back(placeOf(point));
  }
  sheet.x = MarkSheet::around(costs, kFrontRoom);
  sheet.x.text = timeText;
  sheet.y = MarkSheet::around(errors, kFrontRoom);
  sheet.y.text = lengthText;
  sheet.y.lines_a_tick = 1.5;
  sheet.way_line = {&Theme::constraint};
  sheet.way_width = 2.0;
  for (const bool on_front : {false, true}) {  // those that matter lie on top
    const MarkSheet::Colour line =
        on_front ? MarkSheet::Colour{&Theme::constraint} : MarkSheet::Colour{&Theme::ink, 0.55};
    for (const trade::Point& point : points) {
      if (point.on_front == on_front)
        sheet.marks.push_back({placeOf(point), kFrontDot, line, 1.2, on_front ? line : kFrontGround});
    }
  }
  for (const trade::Point& point : points) {
    if (point.is_own)
      sheet.marks.push_back({placeOf(point), kFrontSquare, kFrontGround, 1.0, MarkSheet::Colour{&Theme::target}, true});
  }
  if (chosen) sheet.marks.push_back({placeOf(points[*chosen]), kFrontRing, {&Theme::ink}, 2.0});
  return sheet;
}

}  // namespace underact::gui
