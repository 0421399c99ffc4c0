#include "app/gui/registration/registration_wizard.h"

#include <QBoxLayout>
#include <QTableWidget>

#include "app/gui/registration/reference_points_picture.h"

namespace underact::gui {

RegistrationWizard::RegistrationWizard(RegistrationTool& tool, const ThemeWatcher& theme, QWidget* parent)
    : Procedure("registration", tr("Register the arm"), parent), tool_(tool), theme_(theme) {
  setButtonText(FinishButton, tr("&Accept"));
  setPages({preparePage(), touchPage(), fitPage()}, "accept", 46);
}

RegistrationWizard::~RegistrationWizard() {
  disconnect(&tool_, nullptr, this, nullptr);
  tool_.stopTouching();
}

void RegistrationWizard::poll() {
  pollArm();
  pollTip();
}

/// Of the reference points, beside their table.
ReferencePointsPicture* RegistrationWizard::addPicture(ProcedurePage* page, QTableWidget* table, const char* name) {
  auto* picture = inTheme(theme_, new ReferencePointsPicture(name, page));
  auto* both = new QHBoxLayout;
  both->addWidget(table, 1);
  both->addWidget(picture, 1);
  page->column()->addLayout(both, 1);
  return picture;
}

}  // namespace underact::gui
