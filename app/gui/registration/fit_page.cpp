#include <QHBoxLayout>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/words.h"
#include "app/gui/registration/reference_points_picture.h"
#include "app/gui/registration/registration_wizard.h"
#include "core/base/units.h"
#include "core/registration/check.h"
#include "core/registration/error.h"

namespace underact::gui {
namespace {

QString mm(double length_m) {
  return numberText(kMillimetrePerMetre * length_m, 2);
}

}  // namespace

ProcedurePage* RegistrationWizard::fitPage() {
  auto* page = new ProcedurePage("registration.result", tr("Check the result"), 8);
  residual_ = messageLabel("registration.residual", tr("How well the points fit"), "", page);
  expected_ = messageLabel("registration.expected", tr("Expected error"), "", page);
  expected_->setToolTip(
      tr("e<sup>2</sup>/N · (1 + (d₁²/f₁² + d₂²/f₂² + d₃²/f₃²)/3): Fitzpatrick, West and Maurer, 1998."));
  warnings_ = messageLabel("registration.warnings", tr("Warnings"), "warning", page);
  for (QLabel* label : {residual_, expected_, warnings_}) page->column()->addWidget(label);
  residuals_ = page->table("registration.residuals", tr("Residual of each reference point"),
                           {tr("Point"), tr("residual, mm"), tr("spread, mm")});
  fit_picture_ = addPicture(page, residuals_, "registration.result_picture");
  unsaved_ = messageLabel("registration.kept", tr("Whether the registration was saved"), "alarm", page);
  page->column()->addWidget(unsaved_);
  page->enter = [this] { showFit(); };
  page->may_leave = [this] { return acceptFit(); };
  return page;
}

void RegistrationWizard::showFit() {
  was_told_ = false;
  unsaved_->hide();
  const std::vector<registration::Touch> touches = tool_.run().touching().touches();
  const Result<registration::Fit> fitted = tool_.run().fit();
  if (!fitted) return;  // the page before does not allow this
  const registration::Fit& fit = fitted.value();
  residual_->setText(
      tr("The touched points lie %1 mm from their reference points (root mean square).").arg(mm(fit.rms_m)));
  const registration::ErrorInTheMiddle middle = errorInTheMiddle(touches, fit);
  expected_->setText(tr("Expected error at the centre of the workspace: %1 mm; at most %2 mm in 19 of 20 registrations "
                        "like this one. More reference points, and points farther apart, make it smaller.")
                         .arg(mm(middle.expected_m), mm(middle.likely_max_m)));
  QStringList sentences;
  for (const registration::Warning& warning : warningsOf(touches, fit)) sentences << sentenceText(warning.sentence);
  showMessage(warnings_, sentences.join('\n'));
  residuals_->setRowCount(static_cast<int>(touches.size()));
  std::vector<ShownPoint> shown;
  for (std::size_t at = 0; at < touches.size(); ++at) {
    setRow(residuals_, static_cast<int>(at),
           {QString::number(at + 1), mm(fit.off_D[at].norm()), mm(touches[at].spread_m)});
    shown.push_back({touches[at].p_DM, true, fit.off_D[at]});
  }
  fit_picture_->present(shown, {});
}

bool RegistrationWizard::acceptFit() {
  if (was_told_) return true;
  const Problems problems = tool_.accept();
  if (problems.empty()) return true;
  was_told_ = true;
  unsaved_->setText(
      tr("The registration is in use, but only until the window closes. %1 Press Accept again to close the wizard.")
          .arg(sentencesOf(problems)));
  unsaved_->show();
  return false;
}

}  // namespace underact::gui
