#pragma once
#include <QPushButton>

namespace underact::gui {

class SceneView;

/// Says over the view that there is no force, and starts the servo when it is pressed.
class StopBanner : public QPushButton {
  Q_OBJECT
 public:
  explicit StopBanner(SceneView& view);
  /// Called each frame.
  void present(bool is_off);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  SceneView& view_;
};

}  // namespace underact::gui
