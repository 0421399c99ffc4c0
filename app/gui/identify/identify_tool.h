#pragma once
#include <QObject>
#include <QPointer>

#include "app/gui/identify/arm_in_use.h"
#include "app/gui/identify/identify_run.h"
#include "app/gui/theme.h"

namespace underact::gui {

class Actions;
class IdentifyWizard;

/// "Measure the arm" in the window: its actions, its wizard, and which arm is simulated.
class IdentifyTool : public QObject {
  Q_OBJECT
 public:
  IdentifyTool(const IdentifyParts& parts, Actions& actions, QWidget* window);
  ~IdentifyTool() override;
  void add(const servo::TickRecord& record) { run_.add(record); }
  void look(const servo::Snapshot& snapshot) { run_.look(snapshot); }
  void setTheme(const Theme& theme);
  /// The scene's own is in effect again, and the wizard is closed.
  void end();
  const IdentifyRun& run() const { return run_; }

 private:
  void open();
  bool openArm(const QString& path);

  IdentifyParts parts_;
  Actions& actions_;
  QWidget* window_;
  IdentifyRun run_;
  QPointer<IdentifyWizard> wizard_;
  Theme theme_ = Theme::light();
};

}  // namespace underact::gui
