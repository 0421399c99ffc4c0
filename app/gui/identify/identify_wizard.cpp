#include "app/gui/identify/identify_wizard.h"

#include <QAbstractButton>

#include "app/gui/identify/pages.h"
#include "app/gui/kit/wizard_frame.h"
#include "app/gui/kit/words.h"

namespace underact::gui {

IdentifyWizard::IdentifyWizard(IdentifyRun& run, ArmInUse& in_use, ServoFacts servo, QWidget* parent)
    : QWizard(parent), run_(run) {
  setObjectName("identify.wizard");
  setWindowTitle(tr("Measure the arm"));
  setModal(false);
  setWizardStyle(QWizard::ModernStyle);
  setOption(QWizard::NoBackButtonOnStartPage);
  const QString device = sentenceText(servo.device().title);
  auto* place = new PlacePage(servo.rateHz(), device, this);
  measure_ = new MeasurePage(run, *place, this);
  found_ = new FoundPage(run, this);
  keep_ = new KeepPage(run, *place, in_use, this);
  addPage(new IntroPage(run.hasSimulatedPerson(), this));
  addPage(place);
  addPage(measure_);
  addPage(found_);
  addPage(keep_);
  const std::pair<WizardButton, const char*> names[] = {{BackButton, "identify.back"},
                                                        {NextButton, "identify.next"},
                                                        {FinishButton, "identify.finish"},
                                                        {CancelButton, "identify.cancel"}};
  frameWizard(*this, names, 54);
  connect(&run_, &IdentifyRun::changed, this, [this] {
    if (run_.state() == IdentifyRun::State::Done && currentPage() == measure_) next();
  });
}

IdentifyWizard::~IdentifyWizard() {
  disconnect(&run_, nullptr, this, nullptr);
  run_.cancel();
}

void IdentifyWizard::setTheme(const Theme& theme) {
  measure_->setTheme(theme);
  found_->setTheme(theme);
}

KeepPage* IdentifyWizard::keepPage() {
  return run_.state() == IdentifyRun::State::Done && currentPage() == keep_ ? keep_ : nullptr;
}

}  // namespace underact::gui
