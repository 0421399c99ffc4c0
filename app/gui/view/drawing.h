#pragma once
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <QMap>
#include <QString>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/view/pieces.h"
#include "app/gui/view/workspace_picture.h"
#include "core/chain/dh.h"

namespace underact::gui {

// What a panel draws into the view beside the scene; m, in W.

struct DrawnFrame {
  Pose X_WF = Pose::Identity();
  QString name;
  double axis_m = 0.024;
  bool has_letters = true;  // x, y, z at the axes' ends; otherwise its name is at the end of z
};

struct DrawnLink {
  Vec3 from_W = Vec3::Zero(), to_W = Vec3::Zero();
  bool dashed = false;
  double strength = 1.0;  // opacity of its colour over the background, 0 to 1
};

struct DrawnJoint {
  chain::JointType type = chain::JointType::Revolute;
  Vec3 p_W = Vec3::Zero();
  Vec3 axis_W = Vec3::UnitZ();
};

/// A stylus that nobody holds: drawn hollow, at the size of the real one.
struct DrawnStylus {
  Vec3 p_W = Vec3::Zero();      // its tip
  Vec3 axis_W = Vec3::UnitZ();  // from there to the hand, of length 1
};

/// Text in large type, one line below its position.
struct DrawnWords {
  QString text;
  Vec3 p_W = Vec3::Zero();
};

/// A length or an angle, lit: thick, in the colour of an axis, with its name and value beside it.
struct DrawnMeasure {
  QString text;
  int axis = 0;                  // whose colour: 0 x, 1 y, 2 z
  Vec3 p_W = Vec3::Zero();       // where it begins; the centre of an angle's arc
  Vec3 to_end_W = Vec3::Zero();  // of a length: to its end; of an angle: its first leg
  double turn_rad = 0.0;         // of an angle; 0: it is a length
  Vec3 axis_W = Vec3::UnitZ();   // about which the angle turns
};

/// A place that the tip should reach: a ball of rings, with its name.
struct DrawnTarget {
  QString text;
  Vec3 p_W = Vec3::Zero();
  double radius_m = 0.0;
  bool reached = false;  // drawn faint
};

struct Drawing {
  std::vector<DrawnFrame> frames;
  std::vector<DrawnLink> links;
  std::vector<DrawnJoint> joints;
  std::vector<DrawnStylus> styluses;
  std::vector<DrawnWords> words;
  std::vector<DrawnMeasure> measures;
  std::vector<DrawnTarget> targets;
  bool isEmpty() const {
    return frames.empty() && links.empty() && joints.empty() && styluses.empty() && words.empty() && measures.empty() &&
           targets.empty();
  }
};

/// Frames with their letters, links as lines, joints as the rings and squares of mechanical drawings, a ghost's stylus;
/// in the colour of virtual robots.
class DrawingPicture {
 public:
  DrawingPicture();
  void setTheme(const Theme& theme);
  void setLineWidth(double device_pixels_per_pixel);
  /// Replaces what that owner drew before; empty: nothing. Parts with numbers that are not finite are left out.
  void draw(const QString& owner, const Drawing& drawing);
  vtkActor* mark() const { return actor_; }
  vtkActor* lit() const { return lit_actor_; }  // the measures
  const std::vector<Label>& labels() const { return labels_; }
  std::size_t framesDrawn() const;
  std::size_t targetsDrawn() const;

 private:
  void build();
  void add(const DrawnFrame& frame);
  void add(const DrawnLink& link);
  void add(const DrawnJoint& joint);
  void add(const DrawnStylus& stylus);
  void add(const DrawnMeasure& measure);
  void add(const DrawnTarget& target);
  void add(const DrawnWords& words);

  Theme theme_ = Theme::light();
  QMap<QString, Drawing> drawings_;
  Lines lines_, lit_;
  vtkSmartPointer<vtkActor> actor_, lit_actor_;
  std::vector<Label> labels_;
};

}  // namespace underact::gui
