#pragma once
#include <QObject>
#include <functional>
#include <string>
#include <vector>

#include "core/scene/settings.h"

namespace underact::gui {

class Actions;
class Document;

/// Which virtual manipulator of the scene is at hand, and what can be asked of it, by hand or by the name of a command.
/// Every change goes through the document, so that each is a step back, and is refused as a whole where it cannot be.
class RobotEdits : public QObject {
  Q_OBJECT
 public:
  explicit RobotEdits(Document& document, QObject* parent);
  void addCommands(Actions& actions);

  /// Another scene: the first of its robots.
  void forget() { name_.clear(); }
  /// After an edit: the one of the same name, or the first. Gives the robots' places among the constraints.
  std::vector<std::size_t> look();
  const scene::VirtualManipulator* robot() const;  // null: the scene has none
  std::size_t index() const { return index_; }     // of its constraint
  /// The turn of its tip at home, three angles: as they were typed, since at ry = 90 degrees others make the same turn.
  const Vec3& angles_deg();

  // false: refused.
  bool choose(int number);  // from 0, among the robots
  /// A setting of it, by its path from there on, "/solver/method", and what has to go with it. fresh: a step of its
  /// own.
  bool set(const std::string& path, const scene::SettingValue& value, bool fresh);
  bool setJoint(int joint, int field, const QString& text);
  bool addJoint(int after);
  bool removeJoint(int joint);
  bool moveJoint(int joint, int by);
  bool setHome(int row, int axis, const QString& text);  // row 0: place, 1: turn
  bool addRobot();
  bool removeRobot();

 signals:
  /// Something was asked for, and is in effect where there are no problems.
  void asked(const underact::Problems& problems);
  void chosen();
  void jointMoved(int joint);  // or came: there it is now

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
