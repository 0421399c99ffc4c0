#pragma once
#include <memory>
#include <vector>

#include "app/gui/files/add_dialog.h"
#include "core/scene/description.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace underact::gui {

/// What a file of points holds, and the choice of how they are joined, of their unit, and whether the curve goes into
/// the scene that is there.
class CurveDialog : public AddDialog {
  Q_OBJECT
 public:
  /// can_add: there is a scene.
  CurveDialog(const QString& path, std::shared_ptr<const std::vector<Vec3>> points, bool can_add, QWidget* parent);
  scene::Constraint constraint() const override;

 private:
  void buildChoices();
  void proposeUnit();
  void refresh();

  std::shared_ptr<const std::vector<Vec3>> points_;
  Vec3 low_, high_;   // of all points, in the file's unit
  double way_ = 0.0;  // from point to point
  QComboBox* kind_ = nullptr;
  QCheckBox* closed_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
};

}  // namespace underact::gui
