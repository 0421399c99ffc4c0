#pragma once
#include <optional>

#include "app/gui/files/add_dialog.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/report.h"
#include "core/scene/description.h"

class QButtonGroup;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace underact::gui {

/// What a mesh file contains, what was repaired and how the mesh can be felt. To add a mesh: also the unit if the size
/// is implausible, side and friction, and whether it goes into the current scene. For a mesh of the scene: only the
/// report.
class MeshDialog : public AddDialog {
  Q_OBJECT
 public:
  /// mm_per_unit: of a mesh of the scene, for its report; none: the mesh is to be added. can_add: a scene is open.
  MeshDialog(const QString& path, const mesh_file::Loaded& loaded, std::optional<double> mm_per_unit, bool can_add,
             QWidget* parent);
  scene::Constraint constraint() const override;

 private:
  void buildUnits(const mesh_file::Proposal& proposal);
  void buildChoices();
  void buildFoot(bool is_to_add, bool can_add);
  double mmPerUnit() const;
  void refresh();
  QString text() const;

  mesh_file::Loaded loaded_;
  QString name_;
  double mm_per_unit_ = 1.0;
  std::vector<double> units_;  // mm per unit, of each button
  QButtonGroup* unit_ = nullptr;
  QLabel* report_;
  QComboBox* side_ = nullptr;
  QCheckBox* friction_ = nullptr;
  QDoubleSpinBox* static_ = nullptr;
  QDoubleSpinBox* dynamic_ = nullptr;
};

}  // namespace underact::gui
