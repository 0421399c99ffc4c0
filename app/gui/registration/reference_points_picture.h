#pragma once
#include <optional>
#include <vector>

#include "app/gui/kit/painted.h"
#include "core/base/types.h"

namespace underact::gui {

/// A reference point as the picture shows it.
struct ShownPoint {
  Vec3 p_D = Vec3::Zero();
  bool touched = false;
  std::optional<Vec3> off_D = {};  // residual: from the reference point to the touched one
};

/// The desk from above, the far side at the top: the reference points with their numbers, the one that is due, and the
/// residuals, enlarged.
class ReferencePointsPicture : public Painted {
  Q_OBJECT
 public:
  ReferencePointsPicture(const QString& object_name, QWidget* parent);
  /// due: the reference point to touch next, if any.
  void present(std::vector<ShownPoint> marks, std::optional<std::size_t> due);
  QSize sizeHint() const override { return {420, 260}; }
  QSize minimumSizeHint() const override { return {200, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintOff(QPainter& painter, const ShownPoint& mark, const QPointF& at, double scale) const;

  std::vector<ShownPoint> marks_;
  std::optional<std::size_t> due_;
};

}  // namespace underact::gui
