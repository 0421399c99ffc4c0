#pragma once
#include <functional>
#include <string>

#include "app/gui/feature/panel.h"
#include "core/scene/settings.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace underact::gui {

class ChainSection;
class HomeSection;
class PullSection;
class RobotNowSection;
class SolverSection;

/// The virtual manipulators of the scene: what they pull with, their joints, the solver, and what it does now. Every
/// change goes through the document, so that each is a step back, and is refused as a whole where it cannot be.
class RobotPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Document& document;
    Actions& actions;
  };
  RobotPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

 private:
  using Change = std::function<Problems(scene::VirtualManipulator& robot)>;

  void build();
  void connectSections();
  void addCommands();
  void sceneOpened();
  void refresh();
  void listRobots();
  const scene::VirtualManipulator* robot() const;  // that is shown; null: the scene has none
  /// Edits the robot that is shown. fresh: a step of its own. false: refused, and said why.
  bool change(const QString& what, bool fresh, const Change& change);
  bool send(const scene::Description& edited, const QString& what, bool fresh);
  bool refuse(const Problems& problems);

  /// A setting of the robot shown, by its path from there on: "/solver/method".
  bool set(const std::string& path, const scene::SettingValue& value, bool fresh);
  bool setKo(double ko_N_mm_per_rad, bool fresh);
  bool setOrientation(manipulator::Orientation orientation);
  bool setLaw(manipulator::ForceLaw law);
  bool setMethod(scene::SolverMethod method);
  bool setMaxSteps(int max_steps);
  bool setTolerance(const QString& text);
  bool setJoint(int joint, int field, const QString& text);
  bool addJoint(int after);
  bool removeJoint(int joint);
  bool moveJoint(int joint, int by);
  bool setHome(int row, int axis, const QString& text);
  bool addRobot();
  bool removeRobot();
  bool choose(int number);  // from 0, among the robots

  Parts parts_;
  std::size_t index_ = 0;  // of the constraint that is shown
  std::string name_;       // and its name
  int gesture_ = 0;
  std::int64_t shown_ns_ = -1;  // of the tick whose numbers are shown
  QFormLayout* choices_ = nullptr;
  QComboBox* chooser_ = nullptr;
  QWidget* editor_ = nullptr;  // everything that is about a robot
  QLabel* none_ = nullptr;
  QLabel* refusal_ = nullptr;
  QPushButton *new_ = nullptr, *remove_ = nullptr;
  PullSection* pull_ = nullptr;
  RobotNowSection* now_ = nullptr;
  ChainSection* chain_ = nullptr;
  HomeSection* home_ = nullptr;
  SolverSection* solver_ = nullptr;
};

}  // namespace underact::gui
