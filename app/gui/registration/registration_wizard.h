#pragma once
#include "app/gui/kit/procedure.h"
#include "app/gui/registration/registration_tool.h"

class QComboBox;
class QProgressBar;
class QSpinBox;

namespace underact::gui {

class ReferencePointsPicture;

/// "Register the arm": the arm, whether it is calibrated, the reference points and their sheet; the touching of one
/// point after the other; the result, to be accepted or not. Closing it keeps the previous registration.
class RegistrationWizard : public Procedure {
  Q_OBJECT
 public:
  RegistrationWizard(RegistrationTool& tool, const ThemeWatcher& theme, QWidget* parent);
  ~RegistrationWizard() override;
  void poll();  // each frame
  /// Saves the sheet of reference points as a PDF and says whether it worked. false: nothing was written.
  bool saveSheet(const QString& path);

 private:
  ProcedurePage* preparePage();
  ProcedurePage* touchPage();
  ProcedurePage* fitPage();
  ReferencePointsPicture* addPicture(ProcedurePage* page, QTableWidget* table, const char* name);

  void addArm();
  void addMarks();
  RegistrationTool::Which which() const;
  std::vector<Vec3> points_D() const;
  void fillMarks();
  void showMarks();
  void showArm();
  void pollArm();
  void forget();

  void showTouches();
  void pollTip();

  void showFit();
  bool acceptFit();

  RegistrationTool& tool_;
  const ThemeWatcher& theme_;
  ProcedurePage *prepare_ = nullptr, *touch_ = nullptr;
  QComboBox *arm_ = nullptr, *paper_ = nullptr;
  QLabel *state_ = nullptr, *calibration_ = nullptr, *layout_ = nullptr;
  QPushButton *forget_ = nullptr, *sheet_ = nullptr;
  QSpinBox* count_ = nullptr;
  bool is_ready_ = false, marks_are_good_ = false;
  QLabel *prompt_ = nullptr, *told_ = nullptr, *tip_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *hold_ = nullptr, *again_ = nullptr;
  QLabel *residual_ = nullptr, *expected_ = nullptr, *warnings_ = nullptr, *unsaved_ = nullptr;
  bool was_told_ = false;  // that it could not be saved
  QTableWidget *marks_ = nullptr, *touched_ = nullptr, *residuals_ = nullptr;
  ReferencePointsPicture *marks_picture_ = nullptr, *touch_picture_ = nullptr, *fit_picture_ = nullptr;
};

}  // namespace underact::gui
