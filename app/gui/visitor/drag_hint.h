#pragma once
#include <QVariantAnimation>

#include "app/gui/kit/painted.h"

namespace underact::gui {

class SceneView;

/// A pointer that takes the stylus and drags it, again and again, over the view: what a visitor can do. It takes no
/// clicks.
class DragHint : public Painted {
  Q_OBJECT
 public:
  explicit DragHint(SceneView& view);
  /// Called each frame. on: nobody has done it for a while.
  void present(bool on);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  SceneView& view_;
  QVariantAnimation progress_;
};

}  // namespace underact::gui
