#pragma once
#include <optional>

#include "app/gui/feature/panel.h"
#include "core/lab/step_response.h"

class QComboBox;
class QLabel;

namespace underact::gui {

class StepFigures;
class StepFoot;
class StepPlot;
class StepRows;
struct StepPicture;

/// Step responses (appendix B of the thesis): of a mass under a control law, with the measured response of the
/// simulated arm over it, or those of the thesis's own figures. Its sliders do not edit the scene; gains are copied
/// from the scene and to it on request.
class StepPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Document& document;
    Actions& actions;
    ServoRate& rate;
    ArmInUse& arm_in_use;
  };
  StepPanel(const Parts& parts, QWidget* parent);
  void setTheme(const Theme& theme) override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void build();
  void connectParts();
  void addCommands();
  void takeArm();
  void sceneOpened();
  void sceneEdited();
  void listConstraints();
  bool showFigure(int figure);  // 0: the arm; 1 to 5: B.1 to B.5
  bool setLaw(scene::LawType law);
  bool setQuantity(int quantity, double value);
  bool takeFromScene();
  bool giveToScene();
  bool measure();
  void refresh();
  StepPicture pictureOfArm(QString& note) const;
  QString noteOnMeasured() const;
  lab::HeldMass own() const;              // the scene's gains on the arm's mass
  const scene::Control& control() const;  // of the chosen constraint

  Parts parts_;
  std::size_t index_ = 0;  // of the constraint that is measured and whose gains are copied
  int figure_ = 0;
  scene::LawType law_ = scene::LawType::P;
  lab::HeldMass held_;
  bool is_stale_ = true;                  // what is shown is older than the values
  std::optional<lab::ArmStep> measured_;  // with the values shown; none: not measured, or changed since

  StepPlot* plot_ = nullptr;
  QComboBox* figure_choice_ = nullptr;
  QLabel* what_ = nullptr;
  StepFigures* figures_ = nullptr;
  StepRows* rows_ = nullptr;
  StepFoot* foot_ = nullptr;
  QLabel* note_ = nullptr;
};

}  // namespace underact::gui
