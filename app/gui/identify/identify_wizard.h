#pragma once
#include <QWizard>

#include "app/gui/identify/identify_run.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/servo_facts.h"

namespace underact::gui {

class FoundPage;
class KeepPage;
class MeasurePage;

/// "Measure the arm", page by page. Not modal; closing it ends the measurement.
class IdentifyWizard : public QWizard {
  Q_OBJECT
 public:
  IdentifyWizard(IdentifyRun& run, ArmInUse& in_use, ServoFacts servo, QWidget* parent);
  ~IdentifyWizard() override;
  void setTheme(const Theme& theme);
  /// The last page while it is shown and there is a result; else null.
  KeepPage* keepPage();

 private:
  IdentifyRun& run_;
  MeasurePage* measure_;
  FoundPage* found_;
  KeepPage* keep_;
};

}  // namespace underact::gui
