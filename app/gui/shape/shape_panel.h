#pragma once
#include "app/gui/feature/panel.h"
#include "core/scene/description.h"

class QMenu;
class QScrollArea;
class QToolButton;

namespace underact::gui {

class Readout;

/// The geometry of the constraints in numbers, and the present distance of the tip.
class ShapePanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    Actions& actions;
  };
  ShapePanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

 private:
  void sceneOpened();
  void sceneEdited();
  void addDistance();
  void showShapeFully();
  QToolButton* addButton(const char* name, const QString& text, const QString& tip);
  void offerReports();

  Parts parts_;
  Readout* readout_;
  QScrollArea* scroll_ = nullptr;
  QToolButton* edit_ = nullptr;    // opens the Robot panel
  QToolButton* report_ = nullptr;  // of a mesh
  QMenu* reports_ = nullptr;       // if there are several meshes
  scene::Description shown_;
  std::vector<int> distance_rows_;  // one for each constraint
};

}  // namespace underact::gui
