#pragma once
#include <array>
#include <optional>

#include "app/gui/feature/panel.h"
#include "core/lab/step_response.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace underact::gui {

class NumberTable;
class StepPlot;
class ValueRow;
struct StepPicture;

/// Step responses (appendix B of the thesis): of a mass that a law holds, with the simulated arm's measured one over
/// it, or of the thesis's own figures. Its sliders are its own, and no edits of the scene; gains are taken from the
/// scene and given to it when asked.
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

 private:
  enum Quantity { kKp, kKd, kKi, kMass, kDamping, kQuantities };

  // step_panel_build.cpp
  void build();
  void buildRows(QVBoxLayout* column);
  void buildMeasuring(QWidget* foot);
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
  void refreshTable(const StepPicture& picture);
  QString noteOnMeasured() const;
  double& valueOf(int quantity);          // of held_, SI
  const scene::Control& control() const;  // of the constraint that is chosen

  Parts parts_;
  std::size_t index_ = 0;  // of the constraint whose gains are taken, given and measured
  int figure_ = 0;
  scene::LawType law_ = scene::LawType::P;
  lab::HeldMass held_;
  std::optional<lab::ArmStep> measured_;  // with what is shown; none: nothing was, or something has changed since

  StepPlot* plot_ = nullptr;
  QComboBox* figure_choice_ = nullptr;
  QLabel* what_ = nullptr;
  NumberTable* table_ = nullptr;
  QLabel* poles_ = nullptr;
  QWidget *arm_ = nullptr, *measuring_ = nullptr;  // all that is about the arm
  QFormLayout* choices_ = nullptr;
  QComboBox* constraint_ = nullptr;
  QComboBox* law_choice_ = nullptr;
  std::array<ValueRow*, kQuantities> rows_{};
  QDoubleSpinBox* step_mm_ = nullptr;
  QCheckBox* limits_ = nullptr;
  QLabel* note_ = nullptr;
};

}  // namespace underact::gui
