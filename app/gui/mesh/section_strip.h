#pragma once
#include <QWidget>

#include "app/gui/feature/follower.h"

class QDoubleSpinBox;

namespace underact::gui {

class Actions;
class MarkedSlider;
class SceneView;

/// Below the view while meshes are cut open: across which axis, where along it, and whether the cut follows the stylus.
/// A hand on the slider ends the following; a double click begins it again.
class SectionStrip : public QWidget, public Follower {
  Q_OBJECT
 public:
  /// Adds "section.move" (to the slider, by a key) and "section.place" (mm along the axis).
  SectionStrip(SceneView& view, Actions& actions, QWidget* parent);
  /// Each frame: there while there is something to cut; shows where the cut is.
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
