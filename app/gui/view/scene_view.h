#pragma once
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <utility>

#include "app/gui/kit/theme.h"
#include "app/gui/model/layers.h"
#include "app/gui/view/desk_picture.h"
#include "app/gui/view/drawing.h"
#include "app/gui/view/orbit_camera.h"
#include "app/gui/view/path_picture.h"
#include "core/arm/branches.h"
#include "core/scene/description.h"
#include "core/servo/snapshot.h"
#include "core/sim/hand.h"

namespace underact::gui {

enum class Camera { Fit, Front, Back, Left, Right, Top, Bottom, Isometric };

/// From where the view is seen.
struct Viewpoint {
  OrbitCamera camera;
  bool fits = true;  // nobody has moved it: it keeps everything in the picture
  bool operator==(const Viewpoint&) const = default;
};

/// The picture of the hand's world: constraint, stylus, target, error line, force arrow, workspace box and triads, in
/// frame W. A function of the scene, the snapshot and the theme; nothing is computed here that core does not offer. The
/// mouse orbits, pans and zooms, and grabs the simulated hand. Without a hand, and with Alt, the arrow keys orbit.
class SceneView : public QWidget {
  Q_OBJECT
 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  void setScene(const scene::Description& scene);
  /// The scene that is shown after an edit: drawn anew only where more than gains has changed.
  void followEdit(const scene::Description& scene);
  void present(const servo::Snapshot& snapshot);  // each frame, GUI thread; asks for one repaint, if it looks different
  /// A second arm's world beside the first, see SecondWorld; none at first.
  void showSecond(const scene::Description& scene);
  void placeSecond(const Pose& X_WS_mm);  // of its own W
  void presentSecond(const servo::Snapshot& snapshot);
  void hideSecond();
  bool showsSecond() const;
  /// Where the desk is; none: the arm is not registered. The picture turns with it, see Layers::from_desk.
  void setDesk(const std::optional<Desk>& desk);
  std::size_t marksDrawn() const;
  void setTheme(const Theme& theme);
  void setLayers(const Layers& layers);
  const Layers& layers() const;
  void look(Camera camera);  // moves in 0.2 s; Fit keeps the direction
  bool moving() const;       // a look() is on its way
  Viewpoint viewpoint() const;
  /// At once, without a way there.
  void setViewpoint(const Viewpoint& viewpoint);
  /// The inverse solution that stands out, whatever the layers are; none: no one. A ghost of the arm goes there from
  /// where the joints are, in 0.8 s, each time this is called, and stays.
  void chooseSolution(const std::optional<arm::Branch>& branch);
  bool ghostMoving() const;  // it is on its way
  /// How many inverse solutions are drawn, and the joints of the one that stands out.
  std::size_t ghostsDrawn() const;
  std::size_t robotsDrawn() const;
  std::optional<arm::JointAngles> chosenGhost_rad() const;
  /// What a panel draws beside the scene, in place of what it drew before; empty: nothing more.
  void draw(const QString& owner, const Drawing& drawing);
  std::size_t framesInDrawings() const;
  /// Where the tip of a recording went; empty: none.
  void setRecordedPath(std::vector<PathPoint> path);
  std::size_t pathPartsDrawn() const;
  /// Triangles of all meshes, as drawn; corners of the patch where the stylus touches one.
  std::size_t trianglesDrawn() const;
  std::size_t patchDrawn() const;
  /// From where to where along an axis of W a cut can meet something: the workspace, and the meshes, and the stylus
  /// that the cut follows, where they are beyond it.
  std::pair<double, double> sectionRange_mm(int axis) const;
  std::size_t cutPartsDrawn() const;  // of the face of the cut
  /// One line over the view; empty: none.
  void setHint(const QString& text);
  /// The largest force of the gauge and the arrow's scale, N.
  void setForceLimit(double continuous_N);
  /// How much larger the gauge's type is than the view's; 1 at first.
  void setGaugeScale(double scale);
  double gaugeScale() const;
  /// Letters, gauge, triad and hint over the picture; shown at first.
  void showWords(bool on);
  /// Where the stylus is drawn, tip and body, in logical pixels; empty: it is not known yet.
  QRectF stylusOnScreen() const;
  /// A hand can be grabbed (simulated arm): the pointer shows it. A drag starts from the last wish the view emitted,
  /// and from the tip where there was none, or where this was called since.
  void setHandAvailable(bool available);
  /// The hand was wished elsewhere by others (a script, a game controller): drags start from here.
  void setHandWish(const sim::HandWish& wish);

  /// What a drag, the wheel or an arrow key did to the hand. Arrows move 2 mm (Shift 10 mm) in the view's own plane,
  /// Page Up / Down in depth; Ctrl with arrows turns the stylus. Emitted from mouse and key events in the view.
 signals:
  void handGrabbed();  // by the mouse, or the first key
  void handMoved(const underact::sim::HandWish& wish);
  void handReleased();          // nobody moves it any more; it is meant to stay where it was wished last
  void drawn(double frame_ms);  // after each picture: the time it took to draw

 public:
  /// A picture of the view as it is now.
  QImage picture();
  /// Where a point of W (m) is drawn, in the widget's own logical pixels: stories find the stylus by it.
  QPointF screenOf(const Vec3& p_W) const;
  qint64 framesDrawn() const;
  int glErrors() const;          // since the view was made: 0, or something is wrong
  QString graphicsName() const;  // what draws, "llvmpipe ..."; known after the first picture

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
