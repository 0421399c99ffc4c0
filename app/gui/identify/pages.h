#pragma once
#include <QWizardPage>
#include <array>
#include <vector>

#include "app/gui/identify/identify_run.h"
#include "app/gui/kit/theme.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace underact::gui {

class SwingPlot;

/// The introduction: what is measured, and what the hand will have to do.
class IntroPage : public QWizardPage {
  Q_OBJECT
 public:
  IntroPage(bool simulated_person, QWidget* parent);
};

/// The positions about which the tip swings, and which arm it is.
class PlacePage : public QWizardPage {
  Q_OBJECT
 public:
  PlacePage(int rate_hz, const QString& device, QWidget* parent);
  identify::Wanted wanted() const;
  QString device() const;
  QString serial() const;

 private:
  std::array<QDoubleSpinBox*, 3> at_mm_{};
  QCheckBox* more_;
  QLineEdit *device_, *serial_;
};

/// The measurement: the instruction for the hand, the progress, the swings.
class MeasurePage : public QWizardPage {
  Q_OBJECT
 public:
  MeasurePage(IdentifyRun& run, const PlacePage& place, QWidget* parent);
  void initializePage() override;
  void cleanupPage() override;
  bool isComplete() const override;
  void setTheme(const Theme& theme);

 private:
  void begin();
  void showState();
  void showProgress();

  IdentifyRun& run_;
  const PlacePage& place_;
  QLabel *prompt_, *stage_, *why_;
  QProgressBar* progress_;
  SwingPlot* plot_;
  QPushButton *go_, *repeat_;
  QString refused_;  // why it could not begin
};

/// The results.
class FoundPage : public QWizardPage {
  Q_OBJECT
 public:
  FoundPage(IdentifyRun& run, QWidget* parent);
  void initializePage() override;
  void setTheme(const Theme& theme);

 private:
  void showSwings(int index);

  IdentifyRun& run_;
  QLabel* what_;
  QTableWidget* table_;
  QComboBox* which_;
  SwingPlot* plot_;
};

/// What to do with the results: an arm file, a report, and the simulated arm.
class KeepPage : public QWizardPage {
  Q_OBJECT
 public:
  KeepPage(IdentifyRun& run, const PlacePage& place, ArmInUse& in_use, QWidget* parent);
  void initializePage() override;
  /// With the name and the title in the page's fields.
  sim::ArmModelFile file() const;
  bool saveModel(const QString& path);
  bool saveReport(const QString& path);
  bool use();

 private:
  QPushButton* button(const char* name, const QString& text, const QString& tip);
  bool write(const QString& path, const std::string& text);
  QString chooseFile(const QString& what, const QString& suffix, const QString& filter);

  IdentifyRun& run_;
  const PlacePage& place_;
  ArmInUse& in_use_;
  QLineEdit *name_, *title_;
  QLabel *provenance_, *told_;
};

}  // namespace underact::gui
