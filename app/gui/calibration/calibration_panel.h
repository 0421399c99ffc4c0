#pragma once
#include <array>

#include "app/gui/calibration/calibration_run.h"
#include "app/gui/feature/panel.h"
#include "app/gui/kit/procedure.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QProgressBar;
class QSpinBox;
class QStackedWidget;
class QToolButton;

namespace underact::gui {

class MarkChart;
class Readout;

/// Measures the just-noticeable difference of stiffness of a person or a simulated hand: the settings, kept from one
/// measurement to the next; the trials, without a word of stiffness; the result. A run continues while the panel is
/// hidden behind another.
class CalibrationPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Document& document;
    Actions& actions;
  };
  CalibrationPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override { session_->present(snapshot); }
  void finish() override;
  void setTheme(const Theme& theme) override;

 private:
  void addActions();
  ProcedurePage* addPage();
  ProcedurePage* noBeamsPage();
  ProcedurePage* beginPage();
  ProcedurePage* runPage();
  ProcedurePage* resultPage();

  void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& key, const QString& tip);
  void showWho();
  CalibrationSetup setup() const;
  bool begin();

  QToolButton* answerButton(std::size_t side, const QString& name);
  void sceneOpened();
  void showState();
  void showRun();
  void showResult();
  bool save(const QString& path);

  Parts parts_;
  CalibrationRun* session_;
  QStackedWidget* pages_;
  ProcedurePage *no_beams_ = nullptr, *begin_ = nullptr, *run_ = nullptr, *result_ = nullptr;
  double own_N_per_mm_ = 0.0;  // of the scene's softer beam, not rounded to what the field shows
  QDoubleSpinBox *reference_ = nullptr, *weber_ = nullptr;
  QComboBox* who_ = nullptr;
  QSpinBox* seed_ = nullptr;
  QCheckBox* feedback_ = nullptr;
  QLabel *refusal_ = nullptr, *trial_ = nullptr, *hint_ = nullptr, *message_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QWidget* answers_ = nullptr;
  std::array<QToolButton*, 2> buttons_{};
  std::array<QLabel*, 2> pressed_{};
  Readout* numbers_ = nullptr;
  QLabel *none_ = nullptr, *saved_ = nullptr;
  MarkChart* chart_ = nullptr;
};

}  // namespace underact::gui
