#pragma once
#include <array>

#include "app/gui/identify/identify_run.h"
#include "app/gui/kit/procedure.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QProgressBar;

namespace underact::gui {

class SwingPlot;
class ThemeWatcher;

/// "Measure the arm": an introduction; about which positions the tip swings, and which arm it is; the measurement; its
/// results; an arm file, a report, and the simulated arm. Closing it ends the measurement.
class IdentifyWizard : public Procedure {
  Q_OBJECT
 public:
  IdentifyWizard(IdentifyRun& run, const IdentifyParts& parts, const ThemeWatcher& theme, QWidget* parent);
  ~IdentifyWizard() override;
  // What the last page saves; false: also while it is not shown.
  bool saveModel(const QString& path);
  bool saveReport(const QString& path);

 private:
  ProcedurePage* introPage();
  ProcedurePage* placePage();
  ProcedurePage* measurePage();
  ProcedurePage* foundPage();
  ProcedurePage* keepPage();

  identify::Wanted wanted() const;
  void begin();
  void showState();
  void showProgress();
  void showResults();
  void showKept();
  /// The last page is shown, and there is a result.
  bool hasResult() const { return run_.state() == IdentifyRun::State::Done && currentPage() == keep_; }
  /// With the name and the title in the last page's fields.
  sim::ArmModelFile file() const;
  bool write(const QString& path, const std::string& text);
  QString chooseFile(const QString& what, const QString& suffix, const QString& filter);

  IdentifyRun& run_;
  const IdentifyParts& parts_;
  const ThemeWatcher& theme_;
  ProcedurePage *measure_ = nullptr, *keep_ = nullptr;
  std::array<QDoubleSpinBox*, 3> at_mm_{};
  QCheckBox* more_ = nullptr;
  QLineEdit *device_ = nullptr, *serial_ = nullptr, *name_ = nullptr, *title_ = nullptr;
  QLabel *prompt_ = nullptr, *stage_ = nullptr, *why_ = nullptr, *what_ = nullptr, *provenance_ = nullptr,
         *told_ = nullptr;
  QProgressBar* progress_ = nullptr;
  SwingPlot* plot_ = nullptr;
  QPushButton *go_ = nullptr, *repeat_ = nullptr;
  QString refused_;  // why the measurement could not begin
  QTableWidget* table_ = nullptr;
  QComboBox* which_ = nullptr;
};

}  // namespace underact::gui
