#pragma once
#include "app/gui/feature/panel.h"
#include "core/base/result.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace underact::gui {

class ChainSection;
class HomeSection;
class RobotEdits;
class RobotNowSection;
class SettingRows;
class ValueRow;

/// The virtual robots of the scene: their force, joints, home pose and solver, and its current result.
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
  void build();
  QWidget* makeEditor(QWidget* parent);
  QWidget* makePull(QWidget* parent);
  QWidget* makeSolver(QWidget* parent);
  void connectParts();
  void sceneOpened();
  void refresh();
  void listRobots();
  void tell(const Problems& problems);

  Parts parts_;
  RobotEdits* edits_;
  SettingRows* rows_;
  std::int64_t shown_ns_ = -1;  // of the tick whose numbers are shown
  QFormLayout* choices_ = nullptr;
  QComboBox* chooser_ = nullptr;
  QWidget* editor_ = nullptr;  // everything about a robot
  QLabel* none_ = nullptr;
  QLabel* refusal_ = nullptr;
  QPushButton *new_ = nullptr, *remove_ = nullptr;
  ValueRow* ko_ = nullptr;
  RobotNowSection* now_ = nullptr;
  ChainSection* chain_ = nullptr;
  HomeSection* home_ = nullptr;
};

}  // namespace underact::gui
