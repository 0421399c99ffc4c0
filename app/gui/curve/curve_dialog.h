#pragma once
#include <memory>
#include <vector>

#include "app/gui/files/add_dialog.h"
#include "core/scene/description.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace underact::gui {

/// The contents of a file of points, and the choice of the interpolation, of the unit, and whether the curve goes into
/// the current scene.
class CurveDialog : public AddDialog {
  Q_OBJECT
 public:
  /// can_add: a scene is open.
  CurveDialog(const QString& path, std::shared_ptr<const std::vector<Vec3>> points, bool can_add, QWidget* parent);
  scene::Constraint constraint() const override;

 private:
  void buildChoices();
  void proposeUnit();
  void refresh();

  std::shared_ptr<const std::vector<Vec3>> points_;
  Vec3 low_, high_;        // of all points, in the file's unit
  double length_m_ = 0.0;  // the length from point to point
  QComboBox* kind_ = nullptr;
  QCheckBox* closed_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
};

}  // namespace underact::gui
