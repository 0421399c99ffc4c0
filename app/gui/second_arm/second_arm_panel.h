#pragma once
#include "app/gui/feature/panel.h"
#include "app/gui/model/arm_search.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace underact::gui {

class Readout;
class SecondArm;

/// The second arm: on or off, the device, its side, its scene and its state.
class SecondArmPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    Actions& actions;
    SecondArm& second;
  };
  SecondArmPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  QString busyReason() const override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addActions();
  QWidget* buildChoices();
  void fillArms();
  void presentChoices();
  void tell(const QString& sentence);

  Parts parts_;
  SecondArm& second_;
  ArmSearch* search_;
  QCheckBox *on_ = nullptr, *mirrors_ = nullptr;
  QComboBox *arm_ = nullptr, *scene_ = nullptr, *side_ = nullptr;
  QLabel *told_ = nullptr, *opening_ = nullptr;
  QPushButton* file_ = nullptr;
  QWidget* choices_ = nullptr;
  Readout* readout_ = nullptr;
  bool has_scenes_ = false;
  int mode_ = 0, device_ = 0, force_ = 0, tip_ = 0;
};

}  // namespace underact::gui
