#pragma once
#include <QWidget>

#include "app/gui/feature/servo_listener.h"

class QDoubleSpinBox;

namespace underact::gui {

class Actions;
class MarkedSlider;
class SceneView;

/// Below the view while meshes are cut: the axis and the position of the cut, and whether it follows the stylus. Moving
/// the slider ends the following; a double click restarts it.
class SectionStrip : public QWidget, public ServoListener {
  Q_OBJECT
 public:
  /// Adds the commands "section.move" (focuses the slider) and "section.place" (mm along the axis).
  SectionStrip(SceneView& view, Actions& actions, QWidget* parent);
  /// Each frame: shows the position of the cut; visible only while there is a mesh to cut.
  void present(const servo::Snapshot&) override { follow(); }

 private:
  void follow();
  void build();
  void addActions();
  bool hasCut() const;
  bool put(double at_mm);

  SceneView& view_;
  Actions& actions_;
  MarkedSlider* slider_;
  QDoubleSpinBox* number_;
};

}  // namespace underact::gui
