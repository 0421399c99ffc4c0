#pragma once
#include "app/gui/calibration/calibration_run.h"
#include "app/gui/feature/panel.h"

class QStackedWidget;

namespace underact::gui {

class BeginPage;
class ResultPage;
class RunPage;

/// Measures the just-noticeable difference of stiffness of a person or a simulated hand: the staircase from its start
/// to its result. A run continues while the panel is hidden behind another.
class CalibrationPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Document& document;
    Actions& actions;
  };
  CalibrationPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;
  void finish() override;
  void setTheme(const Theme& theme) override;

 private:
  void addActions();
  QWidget* makeNoBeamsPage();
  void sceneOpened();
  void showState();
  bool begin();
  bool save(const QString& path);
  void chooseAndSave();

  Parts parts_;
  CalibrationRun* session_;
  QStackedWidget* pages_;
  QWidget* no_beams_ = nullptr;
  BeginPage* begin_ = nullptr;
  RunPage* run_ = nullptr;
  ResultPage* result_ = nullptr;
};

}  // namespace underact::gui
