#pragma once
#include <QObject>
#include <QPointer>
#include <memory>
#include <string>

#include "app/gui/theme.h"
#include "core/record/fault_file.h"
#include "core/servo/history.h"

class QWidget;

namespace underact::gui {

class Actions;
class FaultDialog;
struct ToldFault;

/// Where faults are kept: one file each, the newest 20.
QString faultFolder();

/// Looks for faults of the servo, and is told of exceptions in the window: each is kept in a file at once, and told in
/// one dialog.
class FaultWatch : public QObject {
  Q_OBJECT
 public:
  FaultWatch(servo::Host& host, Actions& actions, QWidget* window);
  ~FaultWatch() override;
  /// Every tick, in order: a fault of the window has its last second from here.
  void add(const servo::TickRecord& record) { recent_.add(record); }
  /// The servo ticks so many times a second from now on.
  void setRate(int rate_hz);
  /// Each frame, also of a window that nobody sees.
  void look(const servo::Snapshot& snapshot);
  /// The force goes to zero now; the rest is done when what threw has ended.
  void tellException(const std::string& message);
  /// Brings the dialog with the last fault to the front, with the keyboard. False: there was none.
  bool showLast();
  /// On: faults are kept and not told, because somebody else does; off: from now on they are told again.
  void setQuiet(bool on);
  void setTheme(const Theme& theme);

 private:
  void keepAndTell(servo::FaultReport&& report, ToldFault told);
  void tell(const ToldFault& told);
  void tellOfWindow(const std::string& message);
  FaultDialog& dialog();

  servo::Host& host_;
  Actions& actions_;
  QWidget* window_;
  servo::History recent_;
  Theme theme_ = Theme::light();
  QPointer<FaultDialog> dialog_;
  std::unique_ptr<ToldFault> last_;
  bool quiet_ = false;
};

}  // namespace underact::gui
