#pragma once
#include <QWidget>
#include <array>

#include "app/gui/calibration/calibration_run.h"
#include "app/gui/kit/theme.h"

class QAction;
class QLabel;
class QProgressBar;
class QToolButton;

namespace underact::gui {

class Actions;

/// A measurement under way: the trial, which beams were pressed, the two answers. It shows no stiffness.
class RunPage : public QWidget {
  Q_OBJECT
 public:
  explicit RunPage(Actions& actions, QWidget* parent = nullptr);
  void present(const CalibrationRun& session, bool say_right);
  void setTheme(const Theme& theme);

 signals:
  void cancelled();

 private:
  QToolButton* answerButton(const QString& key, const QString& name);

  std::array<QAction*, 2> actions_;
  QLabel *trial_, *note_;
  QProgressBar* progress_;
  QWidget* answers_;
  std::array<QToolButton*, 2> buttons_{};
  std::array<QLabel*, 2> pressed_{};
  QLabel* feedback_;
};

}  // namespace underact::gui
