#pragma once
#include <QWizardPage>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/registration/registration_tool.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace underact::gui {

class ReferencePointsPicture;

/// The arm, whether it is calibrated, the reference points, and their sheet.
class PreparePage : public QWizardPage {
  Q_OBJECT
 public:
  PreparePage(RegistrationTool& tool, QWidget* parent);
  RegistrationTool::Which which() const;
  std::vector<Vec3> points_D() const;
  bool isComplete() const override { return is_ready_ && marks_are_good_; }
  void poll();
  void setTheme(const Theme& theme);
  bool saveSheet(const QString& path);

 private:
  QWidget* buildArm();
  QWidget* buildMarks();
  void fillMarks();
  void showMarks();
  void showArm();
  void forget();
  void chooseSheet();

  RegistrationTool& tool_;
  QComboBox *arm_ = nullptr, *paper_ = nullptr;
  QLabel *state_ = nullptr, *calibration_ = nullptr, *layout_ = nullptr;
  QPushButton *forget_ = nullptr, *sheet_ = nullptr;
  QSpinBox* count_ = nullptr;
  QTableWidget* table_ = nullptr;
  ReferencePointsPicture* picture_ = nullptr;
  bool is_ready_ = false, marks_are_good_ = false;
};

/// The touching of one reference point after the other.
class TouchPage : public QWizardPage {
  Q_OBJECT
 public:
  TouchPage(RegistrationTool& tool, const PreparePage& prepare, QWidget* parent);
  void initializePage() override;
  void cleanupPage() override;
  bool isComplete() const override;
  void poll();
  void setTheme(const Theme& theme);

 private:
  void build();
  void showState();

  RegistrationTool& tool_;
  const PreparePage& prepare_;
  QLabel *prompt_, *told_, *tip_;
  QProgressBar* progress_;
  QPushButton *hold_, *again_;
  QTableWidget* table_;
  ReferencePointsPicture* picture_;
};

/// The result, to be accepted or not.
class FitPage : public QWizardPage {
  Q_OBJECT
 public:
  FitPage(RegistrationTool& tool, QWidget* parent);
  void initializePage() override;
  bool validatePage() override;
  void setTheme(const Theme& theme);

 private:
  RegistrationTool& tool_;
  QLabel *residual_, *expected_, *warnings_, *told_;
  QTableWidget* table_;
  ReferencePointsPicture* picture_;
  bool was_told_ = false;  // that it could not be saved
};

/// A table with columns of equal width.
QTableWidget* pageTable(const char* name, const QString& spoken, const QStringList& columns, QWidget* parent);

}  // namespace underact::gui
