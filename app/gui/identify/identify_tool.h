#pragma once
#include <QObject>
#include <QPointer>

#include "app/gui/feature/feature.h"
#include "app/gui/identify/identify_run.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/arm_in_use.h"

namespace underact::gui {

class IdentifyWizard;

/// "Measure the arm" in the window: its actions, its wizard, and which arm is simulated.
class IdentifyTool : public QObject, public ServoListener {
  Q_OBJECT
 public:
  explicit IdentifyTool(const FeatureParts& parts);
  ~IdentifyTool() override;
  void add(const servo::TickRecord& record) override { run_.add(record); }
  void poll(const servo::Snapshot& snapshot) override { run_.poll(snapshot); }
  void finish() override { end(); }
  /// Restores the scene and closes the wizard.
  void end();
  const IdentifyRun& run() const { return run_; }

 private:
  bool openArm(const QString& path);

  IdentifyParts parts_;
  Actions& actions_;
  const ThemeWatcher& theme_;
  QWidget* window_;
  IdentifyRun run_;
  QPointer<IdentifyWizard> wizard_;
};

}  // namespace underact::gui
