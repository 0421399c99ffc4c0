#pragma once
#include <QSet>
#include <QTimer>
#include <QVariantAnimation>
#include <optional>
#include <vector>

#include "app/gui/view/constraint_picture.h"
#include "app/gui/view/drawing.h"
#include "app/gui/view/gl_surface.h"
#include "app/gui/view/hand_grip.h"
#include "app/gui/view/hand_picture.h"
#include "app/gui/view/influence_picture.h"
#include "app/gui/view/kinematics_picture.h"
#include "app/gui/view/mesh_picture.h"
#include "app/gui/view/robot_picture.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/view/second_world.h"
#include "app/gui/view/shadow_picture.h"
#include "app/gui/view/view_words.h"
#include "app/gui/view/workspace_picture.h"

namespace underact::gui {

// The first look: from the front, a little from the right and above, so that the sphere, the stylus and the arm behind
// it do not overlap.
inline constexpr double kHomeAzimuth_deg = 32.0, kHomeElevation_deg = 20.0;
inline const QMarginsF kRoom_px(28.0, 52.0, 28.0, 44.0);  // about what is fitted; the hint is at the top

/// What a pressed button does.
enum class Drag { None, Hand, Orbit, Pan, Zoom };

/// scene_view.cpp: the interface; scene_view_impl.cpp: drawing; scene_view_events.cpp: mouse and keys.
struct SceneView::Impl {
  explicit Impl(SceneView* owner);

  QSizeF size() const { return view->size(); }

  /// Before each frame, with the context current: the only place where actors are added and removed.
  void before(QSize pixels);
  void showArm();    // according to the snapshot shown
  void awaitArms();  // whose meshes are read in another thread
  void takeArms();
  void paintWords(QPainter& painter);
  std::vector<Vec3> extent() const;
  std::vector<Vec3> selected() const;
  void fit();
  OrbitCamera wanted() const;  // where the camera is, or is moving to
  QMarginsF room_px() const;   // about what is fitted
  void turnToDesk();
  OrbitCamera fitted(const OrbitCamera& looking) const;  // shows everything from there
  void moveTo(const OrbitCamera& wanted);
  void cameraByHand(const OrbitCamera& wanted);  // from now on it stays where the user put it
  bool overStylus(const QPointF& pointer) const;
  std::optional<Vec3> gizmoAt(const QPointF& pointer) const;  // the direction of its ball there
  void showPointer(const QPointF& pointer);
  void take();
  void releaseKeys();

  SceneView* view;
  GlSurface* surface = nullptr;
  ConstraintPicture constraint;
  WorkspacePicture workspace;
  HandPicture hand;
  ShadowPicture shadow;
  KinematicsPicture kinematics;
  InfluencePicture influence;
  RobotPicture robots;
  PathPicture path;
  DeskPicture desk;
  DrawingPicture drawings;
  MeshPicture meshes;
  std::optional<SecondWorld> second;
  scene::Description scene;  // as drawn
  ViewWords words;
  Theme theme = Theme::light();
  Layers layers;
  QString hint;
  double force_limit_N = 0.0, gauge_scale = 1.0;
  int taken_px = 0;  // at the top
  bool has_words = true;
  bool actors_changed = true;
  std::optional<servo::Snapshot> shown;

  OrbitCamera camera, from, to;
  bool camera_is_mine = true;  // not moved by the user: it keeps everything in the picture
  QTimer arms_read;            // looks for the meshes of arms
  QVariantAnimation movement;
  QVariantAnimation ghost_trajectory;  // of the chosen solution's ghost

  HandGrip grip;
  bool hand_available = false;
  bool held_by_mouse = false;
  QSet<int> held_by_keys;
  Drag drag = Drag::None;
  QPointF last, pressed;
};

}  // namespace underact::gui
