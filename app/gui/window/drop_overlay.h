#pragma once
#include "app/gui/files/opening.h"
#include "app/gui/kit/painted.h"

class QLabel;

namespace underact::gui {

class SceneView;

/// Over the view while a file is dragged over the window: that it may land, and what it does then, or why it may not.
class DropOverlay : public Painted {
  Q_OBJECT
 public:
  explicit DropOverlay(SceneView& view);
  void present(const Dragged& dragged);
  const Dragged& dragged() const { return dragged_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  SceneView& view_;
  QLabel *sentence_, *file_;
  Dragged dragged_;
};

}  // namespace underact::gui
