#include "app/gui/registration/registration_wizard.h"

#include <QAbstractButton>

#include "app/gui/kit/wizard_frame.h"
#include "app/gui/registration/pages.h"

namespace underact::gui {

RegistrationWizard::RegistrationWizard(RegistrationTool& tool, QWidget* parent)
    : QWizard(parent),
      tool_(tool),
      prepare_(new PreparePage(tool, this)),
      touch_(new TouchPage(tool, *prepare_, this)),
      result_(new FitPage(tool, this)) {
  setObjectName("registration.wizard");
  setWindowTitle(tr("Register the arm"));
  setModal(false);
  setWizardStyle(QWizard::ModernStyle);
  setOption(QWizard::NoBackButtonOnStartPage);
  for (QWizardPage* page :
       {static_cast<QWizardPage*>(prepare_), static_cast<QWizardPage*>(touch_), static_cast<QWizardPage*>(result_)})
    addPage(page);
  setButtonText(FinishButton, tr("&Accept"));
  const std::pair<WizardButton, const char*> names[] = {{BackButton, "registration.back"},
                                                        {NextButton, "registration.next"},
                                                        {FinishButton, "registration.accept"},
                                                        {CancelButton, "registration.cancel"}};
  frameWizard(*this, names, 46);
}

RegistrationWizard::~RegistrationWizard() {
  disconnect(&tool_, nullptr, this, nullptr);
  tool_.stopTouching();
}

void RegistrationWizard::poll() {
  prepare_->poll();
  touch_->poll();
}

void RegistrationWizard::setTheme(const Theme& theme) {
  prepare_->setTheme(theme);
  touch_->setTheme(theme);
  result_->setTheme(theme);
}

bool RegistrationWizard::saveSheet(const QString& path) {
  return prepare_->saveSheet(path);
}

}  // namespace underact::gui
