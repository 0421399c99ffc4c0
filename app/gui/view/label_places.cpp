#include "app/gui/view/label_places.h"

#include <algorithm>

namespace underact::gui {
namespace {

constexpr double kGap_px = 1.0;

}  // namespace

std::vector<std::optional<QPointF>> placesOfLabels(const std::vector<WantedLabel>& labels, std::vector<QRectF> taken) {
  std::vector<std::optional<QPointF>> places;
  std::vector<std::pair<QString, QRectF>> drawn;
  for (const WantedLabel& label : labels) {
    const double w = label.where.width(), h = label.where.height();
    const std::vector<QPointF> directions =
        label.may_move ? std::vector<QPointF>{{0, 0},  {0, -h}, {0, h},   {w, 0},      {-w, 0},   {w, -h},
                                              {-w, h}, {w, h},  {-w, -h}, {0, -2 * h}, {0, 2 * h}}
                       : std::vector<QPointF>{{0, 0}};
    const bool is_there = std::any_of(drawn.begin(), drawn.end(), [&](const auto& other) {
      return other.first == label.text && other.second.intersects(label.where);
    });
    std::optional<QPointF> place;
    for (const QPointF& direction : directions) {
      if (is_there || place) break;
      const QRectF at = label.where.translated(direction).adjusted(-kGap_px, 0, kGap_px, 0);
      if (std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(at); }))
        place = direction;
    }
    if (place) {
      taken.push_back(label.where.translated(*place));
      drawn.emplace_back(label.text, taken.back());
    }
    places.push_back(place);
  }
  return places;
}

}  // namespace underact::gui
