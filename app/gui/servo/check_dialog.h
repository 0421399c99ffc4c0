#pragma once
#include <QDialog>
#include <memory>

#include "app/gui/servo/check_run.h"

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QTimer;

namespace underact::gui {

/// "How late are the ticks here, and how late would they be in any program?" The button's counterpart of `underact-cli
/// servo-check`. Not modal; closing it ends the check.
class CheckDialog : public QDialog {
  Q_OBJECT
 public:
  CheckDialog(int rate_hz, const system::SchedulingWanted& wanted, QWidget* parent);
  ~CheckDialog() override;
  bool isRunning() const { return run_ != nullptr; }
  /// The verdict, or how far it is: what a screen reader says.
  QString message() const;

 private:
  void begin();
  void look();
  void end();
  void present(const servo::CheckResult& result);

  int rate_hz_;
  system::SchedulingWanted wanted_;
  std::unique_ptr<CheckRun> run_;
  QLabel* message_;
  QSpinBox* seconds_;
  QCheckBox* load_;
  QProgressBar* progress_;
  QTableWidget* table_;
  QPushButton* begin_;
  QTimer* looks_;
};

/// What the figures mean, in a sentence: p99 within 1.3 times and p99.9 within twice those of the bare loop are as good
/// as this machine allows.
QString verdictOf(const servo::CheckResult& result);

}  // namespace underact::gui
