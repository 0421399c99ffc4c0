#pragma once
#include <QWizard>

#include "app/gui/registration/registration_tool.h"

namespace underact::gui {

class PreparePage;
class FitPage;
class TouchPage;

/// "Register the arm", page by page. Not modal, so that the simulated arm's hand can be moved in the view. Closing it
/// keeps the previous registration.
class RegistrationWizard : public QWizard {
  Q_OBJECT
 public:
  RegistrationWizard(RegistrationTool& tool, QWidget* parent);
  ~RegistrationWizard() override;
  void poll();  // each frame
  void setTheme(const Theme& theme);
  /// Saves the sheet of reference points as a PDF and says whether it worked. false: nothing was written.
  bool saveSheet(const QString& path);

 private:
  RegistrationTool& tool_;
  PreparePage* prepare_;
  TouchPage* touch_;
  FitPage* result_;
};

}  // namespace underact::gui
