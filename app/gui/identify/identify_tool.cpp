#include "app/gui/identify/identify_tool.h"

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>

#include "app/gui/identify/identify_wizard.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/model/arm_choice.h"

namespace underact::gui {

IdentifyTool::IdentifyTool(const FeatureParts& parts)
    : QObject(parts.window),
      parts_{parts.servo, parts.control, parts.document, parts.view, parts.player, parts.arm_in_use, parts.arms},
      actions_(parts.actions),
      theme_(parts.theme),
      window_(parts.window),
      run_(parts_, this) {
  connect(&parts.arms, &ArmChoice::began, this, &IdentifyTool::end);  // the measurement was of the previous arm
  actions_.add(
      {"identify.open",
       tr("Me&asure the arm…"),
       {},
       tr("Measures mass, friction, damping, encoder resolution and rendered stiffness of this arm, step by step.")},
      [this](const QVariantList&) {
        openProcedure(wizard_, run_, parts_, theme_, window_);
        return true;
      });
  actions_.add({"arm.open",
                tr("&Open a measured arm…"),
                {},
                tr("Gives the simulated arm the values of a measured arm, from its file.")},
               [this](const QVariantList& path) {
                 if (!path.isEmpty()) return openArm(path.first().toString());
                 const QString chosen =
                     QFileDialog::getOpenFileName(window_, tr("Open a measured arm"), {}, tr("Arm models (*.json)"));
                 return !chosen.isEmpty() && openArm(chosen);
               });
  QAction* const vendors =
      actions_.add({"arm.vendor", tr("&Vendor's arm"), {}, tr("Gives the simulated arm the vendor's values again.")},
                   [this](const QVariantList&) {
                     parts_.in_use.useVendors();
                     return true;
                   });
  const auto follow = [this, vendors] {  // no change of arm during a measurement
    vendors->setEnabled(parts_.in_use.isMeasured() && !run_.isRunning());
    actions_.find("arm.open")->setEnabled(parts_.in_use.hasSimulatedArm() && !run_.isRunning());
  };
  connect(&parts_.in_use, &ArmInUse::changed, this, follow);
  connect(&run_, &IdentifyRun::changed, this, follow);
  follow();
  // The buttons of the last page, with a path instead of a file dialog.
  actions_.addCommand("identify.save", [this](const QVariantList& path) {
    return wizard_ && wizard_->saveModel(path.value(0).toString());
  });
  actions_.addCommand("identify.report", [this](const QVariantList& path) {
    return wizard_ && wizard_->saveReport(path.value(0).toString());
  });
}

IdentifyTool::~IdentifyTool() {
  delete wizard_;
}

bool IdentifyTool::openArm(const QString& path) {
  const Problems problems = parts_.in_use.open(path);
  if (problems.empty()) return true;
  showProblemsBox("dialog.arm_problems", tr("Measured arm"),
                  tr("This file does not describe an arm that can be simulated. The arm is unchanged."), problems,
                  window_);
  return false;
}

void IdentifyTool::end() {
  delete wizard_;
  run_.cancel();
}

}  // namespace underact::gui
