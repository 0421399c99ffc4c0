#pragma once
#include <QWidget>

#include "app/gui/kit/theme.h"
#include "app/gui/view/scene_view.h"

class QLabel;
class QVBoxLayout;

namespace underact::gui {

/// The view, and to its right a second one while two scenes are compared: with the same camera, layers and font. Moving
/// one camera moves the other.
class TwoViews : public QWidget {
  Q_OBJECT
 public:
  TwoViews(SceneView& left, QWidget* parent);
  void showRight(bool on);
  bool showsRight() const;
  /// Only while it is shown.
  SceneView& right() { return *right_; }
  void setHeads(const QString& left, const QString& right);
  /// Each frame.
  void present();
  void setTheme(const Theme& theme);

 private:
  QLabel* head(const char* name, const QString& spoken, QVBoxLayout* column);
  void makeRight();
  void follow();
  void levelHeads();

  SceneView& left_;
  QWidget* right_half_;
  SceneView* right_ = nullptr;  // created when first needed: it costs time and memory
  QLabel *left_head_, *right_head_;
  Viewpoint seen_;   // of both views
  Viewpoint whole_;  // of the left one, before there were two
  Theme theme_ = Theme::light();
};

}  // namespace underact::gui
