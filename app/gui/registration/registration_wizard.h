#pragma once
#include <QWizard>

#include "app/gui/registration/registration_tool.h"

namespace underact::gui {

class PreparePage;
class FitPage;
class TouchPage;

/// "Register the arm", page by page. Not modal: the simulated arm's hand is moved in the view meanwhile. Closing it
/// leaves what there was.
class RegistrationWizard : public QWizard {
  Q_OBJECT
 public:
  RegistrationWizard(RegistrationTool& tool, QWidget* parent);
  ~RegistrationWizard() override;
  void look();  // each frame
  void setTheme(const Theme& theme);
  /// The marks' sheet as a PDF; what came of it is said. false: nothing was written.
  bool saveSheet(const QString& path);

 private:
  RegistrationTool& tool_;
  PreparePage* prepare_;
  TouchPage* touch_;
  FitPage* result_;
};

}  // namespace underact::gui
