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

/// A fault as it is told.
struct ToldFault {
  record::FaultWords words;
  QString when;      // "19:56:47"
  QString path;      // of its file; empty: there is none
  QString not_kept;  // why not
  std::vector<servo::TickRecord> last_second;
  int rate_hz = 1000;
  int times = 1;  // the same came so often
};

/// What went wrong: what happened, what it means, what to do, where the file is. One dialog; a fault that comes while
/// it is open joins the list. It comes without taking the keyboard, so that arrow keys and Esc still go to the window.
class FaultDialog : public QDialog {
  Q_OBJECT
 public:
  explicit FaultDialog(QWidget* parent);
  /// Shows a fault, the others that are still told above it.
  void tell(const ToldFault& fault);
  /// The last one has come again.
  void tellAgain();
  /// Of the faults told since the dialog was opened, the last; null: none.
  const ToldFault* last() const { return faults_.empty() ? nullptr : &faults_.back(); }
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

  std::vector<ToldFault> faults_;
  int shown_ = 0;
  QListWidget* list_;
  QLabel *what_, *meaning_, *to_do_, *file_;
  FaultPlot* plot_;
  QPushButton *start_ = nullptr, *folder_ = nullptr, *copy_ = nullptr;
};

}  // namespace underact::gui
