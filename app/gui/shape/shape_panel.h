#pragma once
#include "app/gui/feature/panel.h"
#include "core/scene/description.h"

class QMenu;
class QScrollArea;
class QToolButton;

namespace underact::gui {

class Readout;

/// What the stylus is held to, in numbers, and how far it is from there now.
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
  void showOneShapeWhole();
  QToolButton* addButton(const char* name, const QString& text, const QString& tip);
  void offerReports();

  Parts parts_;
  Readout* readout_;
  QScrollArea* scroll_ = nullptr;
  QToolButton* edit_ = nullptr;    // opens the joints of a virtual manipulator
  QToolButton* report_ = nullptr;  // on the file of a mesh
  QMenu* reports_ = nullptr;       // where there are several
  scene::Description shown_;
  std::vector<int> distance_rows_;  // of each constraint
};

}  // namespace underact::gui
