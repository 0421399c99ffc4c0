#pragma once
#include <QPointF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

namespace underact::gui {

/// A text that wants to be drawn in a rectangle.
struct WantedLabel {
  QString text;
  QRectF where;
  bool may_move = true;  // beside its place, if that is taken
};

/// How far each text is moved so that none lies over another or over what is `taken`; none: it is not drawn, because it
/// stands there already, or there is no room beside it. In the order of the list: the first ones stay.
std::vector<std::optional<QPointF>> placesOfLabels(const std::vector<WantedLabel>& labels, std::vector<QRectF> taken);

}  // namespace underact::gui
