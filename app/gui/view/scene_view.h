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
#include "core/arm/sample.h"
#include "core/scene/description.h"
#include "core/servo/snapshot.h"
#include "core/sim/hand.h"

namespace underact::gui {

enum class Camera { Fit, Front, Back, Left, Right, Top, Bottom, Isometric, Home };

/// From where the view is seen.
struct Viewpoint {
  OrbitCamera camera;
  bool fits = true;  // not moved by the user: it keeps everything in the picture
  bool operator==(const Viewpoint&) const = default;
};

/// The 3D view: constraints, stylus, target, error line, force arrow, workspace box and triads, in frame W. A function
/// of the scene, the snapshot and the theme; all computation is in core. The mouse orbits, pans and zooms, and grabs
/// the simulated hand. Without a hand, and with Alt, the arrow keys orbit.
class SceneView : public QWidget {
  Q_OBJECT
 public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  void setScene(const scene::Description& scene);
  /// The scene that is shown after an edit: redrawn only if more than gains has changed.
  void followEdit(const scene::Description& scene);
  void present(const servo::Snapshot& snapshot);  // each frame, GUI thread; asks for one repaint, if it looks different
  /// A second arm's world beside the first, see SecondWorld; none at first.
  void showSecond(const scene::Description& scene);
  void placeSecond(const Pose& X_WS_mm);  // pose of its W
  void presentSecond(const servo::Snapshot& snapshot);
  void hideSecond();
  bool showsSecond() const;
  /// Where the desk is; none: the arm is not registered. The picture turns with it, see Layers::from_desk.
  void setDesk(const std::optional<Desk>& desk);
  std::size_t marksDrawn() const;
  void setTheme(const Theme& theme);
  void setLayers(const Layers& layers);
  const Layers& layers() const;
  void moveCamera(Camera camera);     // takes 0.2 s; Fit keeps the direction
  void lookFrom(const Vec3& from_W);  // the same from a direction of W
  /// Shows what is selected: the chosen inverse solution if there is one, else the constraints and the tip.
  void fitSelection();
  /// Orthographic, or in perspective.
  void setParallel(bool on);
  bool isParallel() const;
  bool moving() const;  // a moveCamera() is in progress
  Viewpoint viewpoint() const;
  /// At once, without animation.
  void setViewpoint(const Viewpoint& viewpoint);
  /// The highlighted inverse solution by its number (NumberedSolution), whatever the layers are; 0: no solution. A
  /// ghost of the arm moves there from the current configuration in 0.8 s, each time this is called, and stays.
  void chooseSolution(int number);
  bool solutionMoving() const;  // it is moving
  /// How many inverse solutions are drawn, and the joints of the highlighted one.
  std::size_t solutionsDrawn() const;
  std::size_t robotsDrawn() const;
  std::optional<arm::JointAngles> chosenSolution_rad() const;
  /// What a panel draws beside the scene; replaces what it drew before; empty: nothing.
  void draw(const QString& owner, const Drawing& drawing);
  std::size_t framesInDrawings() const;
  std::size_t targetsInDrawings() const;
  /// The path of the tip in a recording; empty: none.
  void setRecordedPath(std::vector<PathPoint> path);
  std::size_t pathPartsDrawn() const;
  /// Triangles of all meshes, as drawn; corners of the patch where the stylus touches one.
  std::size_t trianglesDrawn() const;
  std::size_t patchDrawn() const;
  /// Why meshes of the scene's arm are not drawn, as armRead() says.
  const Problems& armProblems() const;
  std::size_t dimplesDrawn() const;  // where the stylus pushes into a surface that is no mesh
  /// The range along an axis of W in which a cut can meet something: the workspace, extended by the meshes and by the
  /// stylus if the cut follows it.
  std::pair<double, double> sectionRange_mm(int axis) const;
  std::size_t cutPartsDrawn() const;  // of the face of the cut
  /// One line over the view; empty: none.
  void setHint(const QString& text);
  /// The largest force of the gauge and the arrow's scale, N.
  void setForceLimit(double continuous_N);
  /// The size of the gauge's text relative to the view's; 1 by default.
  void setGaugeScale(double scale);
  double gaugeScale() const;
  /// Letters, gauge, triad and hint over the picture; shown at first.
  void showWords(bool on);
  /// Where the stylus is drawn, tip and body, in logical pixels; empty: it is not known yet.
  QRectF stylusOnScreen() const;
  /// Whether a hand can be grabbed (simulated arm); the pointer shows it. A drag starts from the last setpoint emitted
  /// by the view, or from the tip if there was none since this call.
  void setHandAvailable(bool available);
  /// The hand was moved by another source (a script, a game controller): drags start from here.
  void setHandSetpoint(const sim::HandSetpoint& setpoint);
  /// Whether a hand that only turns the stylus holds its position, too.
  void setKeepsHolding(bool on);

  /// What a drag, the wheel or an arrow key did to the hand. Arrows move 2 mm (Shift 10 mm) in the view's own plane,
  /// Page Up / Down in depth; Ctrl with arrows turns the stylus. Emitted from mouse and key events in the view.
 signals:
  void handGrabbed();  // by the mouse, or the first key
  void handMoved(const underact::sim::HandSetpoint& setpoint);
  void handReleased(bool by_mouse);  // nobody moves it any more
  void parallelChanged(bool on);
  /// A scene is shown, or its arm's meshes have been read since. problems: why some are not drawn.
  void armRead(const underact::Problems& problems);
  void drawn(double frame_ms);  // after each picture: the time it took to draw

 public:
  /// Keeps what is fitted below that many pixels at the top, where a card stands over the view; 0: none does.
  void setTaken(int from_top_px);
  /// A picture of the view as it is now.
  QImage picture();
  /// Where a point of W (m) is drawn, in the widget's own logical pixels: stories find the stylus by it.
  QPointF screenOf(const Vec3& p_W) const;
  qint64 framesDrawn() const;
  int glErrors() const;          // since construction; should be 0
  QString graphicsName() const;  // the renderer, "llvmpipe ..."; known after the first frame

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
