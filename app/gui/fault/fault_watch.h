#pragma once
#include <QObject>
#include <QPointer>
#include <memory>
#include <string>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/theme.h"
#include "core/record/fault_file.h"
#include "core/servo/history.h"

class QWidget;

namespace underact::gui {

class FaultDialog;
struct ShownFault;

/// Looks for faults of the servo and receives exceptions of the window; each is saved in a file at once and shown in
/// one dialog.
class FaultWatch : public QObject, public ServoListener {
  Q_OBJECT
 public:
  FaultWatch(ServoFacts servo, ServoControl control, const ServoRate& rate, Actions& actions, QWidget* window);
  ~FaultWatch() override;
  void add(const servo::TickRecord& record) override { recent_.add(record); }  // for an error in the window
  void poll(const servo::Snapshot& snapshot) override;
  /// Sets the force to zero at once; reports after the event handler that threw has returned.
  void reportException(const std::string& message);
  /// Brings the dialog with the last fault to the front and focuses it. False: there was none.
  bool showLast();
  void setTheme(const Theme& theme) override;

 private:
  void saveAndShow(servo::FaultReport&& report, ShownFault told);
  void tell(const ShownFault& told);
  void reportWindowFault(const std::string& message);
  FaultDialog& dialog();

  ServoFacts servo_;
  ServoControl control_;
  Actions& actions_;
  QWidget* window_;
  servo::History recent_;
  Theme theme_ = Theme::light();
  QPointer<FaultDialog> dialog_;
  std::unique_ptr<ShownFault> last_;
};

}  // namespace underact::gui
