#pragma once
#include <QObject>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/settings.h"

namespace underact::gui {

class Actions;
class Document;

/// The virtual robot of the scene that is edited, and its edits, from the panel or by command. Every change goes
/// through the document, so that each is one undo step and is refused as a whole if it is invalid.
class RobotEdits : public QObject {
  Q_OBJECT
 public:
  explicit RobotEdits(Document& document, QObject* parent);
  void addCommands(Actions& actions);

  /// A new scene: selects the first of its robots.
  void reset() { name_.clear(); }
  /// After an edit: selects the robot of the same name, or the first. Returns the indices of the robots among the
  /// constraints.
  std::vector<std::size_t> poll();
  const scene::VirtualManipulator* robot() const;  // null: the scene has none
  std::size_t index() const { return index_; }     // of its constraint
  /// The orientation of its end effector in the home pose, three angles as typed, since at ry = 90 degrees others give
  /// the same rotation.
  const Vec3& angles_deg();

  // false: refused.
  bool choose(int number);  // from 0, among the robots
  /// Sets one of its settings by the path below it, "/solver/method", and what depends on it. fresh: a separate undo
  /// step.
  bool set(const std::string& path, const scene::SettingValue& value, bool fresh);
  bool setJoint(int joint, int field, const QString& text);
  bool addJoint(int after);
  bool removeJoint(int joint);
  bool moveJoint(int joint, int by);
  bool setHome(int row, int axis, const QString& text);  // row 0: position, 1: orientation
  bool addRobot();
  bool removeRobot();

 signals:
  /// An edit was requested; it is in effect if there are no problems.
  void asked(const underact::Problems& problems);
  void chosen();
  void jointMoved(int joint);  // or added: its new index

 private:
  using Change = std::function<Problems(scene::VirtualManipulator& robot)>;
  bool change(const QString& what, const Change& change);
  bool send(const scene::Description& edited, const QString& what, bool fresh);
  bool refuse(const Problems& problems);

  Document& document_;
  std::size_t index_ = 0;
  std::string name_;  // of its constraint
  int gesture_ = 0;
  Vec3 angles_deg_ = Vec3::Zero();
};

}  // namespace underact::gui
