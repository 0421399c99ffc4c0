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

/// Compares the latency of the servo on this machine with that of a bare loop; the counterpart of `underact-cli
/// servo-check`. Not modal; closing it ends the check.
class CheckDialog : public QDialog {
  Q_OBJECT
 public:
  CheckDialog(int rate_hz, const system::SchedulingRequest& wanted, QWidget* parent);
  ~CheckDialog() override;
  bool isRunning() const { return run_ != nullptr; }
  /// The verdict, or the progress, as a screen reader says it.
  QString message() const;

 private:
  void begin();
  void poll();
  void end();
  void present(const servo::CheckResult& result);

  int rate_hz_;
  system::SchedulingRequest wanted_;
  std::unique_ptr<CheckRun> run_;
  QLabel* message_;
  QSpinBox* seconds_;
  QCheckBox* load_;
  QProgressBar* progress_;
  QTableWidget* table_;
  QPushButton* begin_;
  QTimer* poll_timer_;
};

/// The verdict in a sentence: a p99 within 1.3 times and a p99.9 within twice that of the bare loop are as good as this
/// machine allows.
QString verdictOf(const servo::CheckResult& result);

}  // namespace underact::gui
