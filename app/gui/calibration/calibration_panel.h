#pragma once
#include "app/gui/calibration/session.h"
#include "app/gui/feature/panel.h"

class QStackedWidget;

namespace underact::gui {

class BeginPage;
class ResultPage;
class RunPage;

/// How small a difference of stiffness a person, or a simulated hand, can tell: the staircase from its beginning to its
/// result. A run goes on while the panel stands behind another.
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
  CalibrationSession* session_;
  QStackedWidget* pages_;
  QWidget* no_beams_ = nullptr;
  BeginPage* begin_ = nullptr;
  RunPage* run_ = nullptr;
  ResultPage* result_ = nullptr;
};

}  // namespace underact::gui
