#pragma once
#include <QDialog>
#include <vector>

#include "app/gui/kit/theme.h"
#include "core/record/fault_file.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace underact::gui {

class FaultPlot;

/// A fault as the dialog shows it.
struct ShownFault {
  record::FaultWords words;
  QString when;      // "19:56:47"
  QString path;      // of its file; empty: not saved
  QString not_kept;  // why it was not saved
  std::vector<servo::TickRecord> last_second;
  int rate_hz = 1000;
  int times = 1;  // how often it occurred
};

/// What happened, what it means, what to do and where the fault file is. There is one dialog; a fault that occurs while
/// it is open is added to its list. It does not take the keyboard focus, so that arrow keys and Esc still go to the
/// window.
class FaultDialog : public QDialog {
  Q_OBJECT
 public:
  explicit FaultDialog(QWidget* parent);
  /// Shows a fault, below those already listed.
  void tell(const ShownFault& fault);
  /// The last fault occurred again.
  void tellAgain();
  /// The last fault since the dialog was opened; null: none.
  const ShownFault* last() const { return faults_.empty() ? nullptr : &faults_.back(); }
  void setTheme(const Theme& theme);
  void setStartable(bool can_start);
  int count() const { return static_cast<int>(faults_.size()); }

 signals:
  void startAsked();
  void restartAsked();

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildButtons();
  void fillList();
  void showFault(int index);

  std::vector<ShownFault> faults_;
  int shown_ = 0;
  QListWidget* list_;
  QLabel *what_, *meaning_, *to_do_, *file_;
  FaultPlot* plot_;
  QPushButton *start_ = nullptr, *folder_ = nullptr, *copy_ = nullptr;
};

}  // namespace underact::gui
