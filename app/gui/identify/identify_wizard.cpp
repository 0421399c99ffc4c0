#include "app/gui/identify/identify_wizard.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/identify/swing_plot.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kReach_mm = 200.0;
constexpr double kAside_mm = 20.0;  // of the two more positions, to the left and right of the first

}  // namespace

IdentifyWizard::IdentifyWizard(IdentifyRun& run, const IdentifyParts& parts, const ThemeWatcher& theme, QWidget* parent)
    : Procedure("identify", tr("Measure the arm"), parent), run_(run), parts_(parts), theme_(theme) {
  setPages({introPage(), placePage(), measurePage(), foundPage(), keepPage()}, "finish", 54);
  connect(&run_, &IdentifyRun::changed, this, [this] {
    if (run_.state() == IdentifyRun::State::Done && currentPage() == measure_) next();
  });
}

IdentifyWizard::~IdentifyWizard() {
  disconnect(&run_, nullptr, this, nullptr);
  run_.cancel();
}

ProcedurePage* IdentifyWizard::introPage() {
  auto* page = new ProcedurePage("identify.intro", tr("Measure the arm"), 12);
  page->addText(
      "identify.what",
      tr("This wizard measures the arm: the mass, friction and damping at its tip along x, y and z, the resolution of "
         "its encoders, and the stiffness that it actually renders. At the end you can save an arm file and a "
         "report."));
  page->addText(
      "identify.hand",
      run_.hasSimulatedPerson()
          ? tr("The arm is simulated, and a simulated hand follows the instructions. This takes half a minute.")
          : tr("First let go of the stylus: for about 20 seconds the arm moves it by itself, 20 mm to each side, "
               "with no more force than any scene may use. Then take the stylus, press it down slowly, and "
               "rotate it. This takes about a minute."));
  page->addText("identify.safety", tr("Esc stops the force at any time. The open scene is restored afterwards."));
  page->column()->addStretch(1);
  return page;
}

ProcedurePage* IdentifyWizard::placePage() {
  auto* page = new ProcedurePage("identify.where", tr("Position and arm"), 12);
  auto* form = new QFormLayout;
  page->column()->addLayout(form);
  const double middle_mm[] = {0.0, 0.0, 60.0};
  const QString labels[] = {tr("Position &x"), tr("Position &y"), tr("Position &z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at_mm_[axis] = new NumberBox(page);
    at_mm_[axis]->setObjectName(QString("identify.place.%1").arg(QLatin1Char("xyz"[axis])));
    at_mm_[axis]->setAccessibleName(QString(labels[axis]).remove('&'));
    at_mm_[axis]->setRange(-kReach_mm, kReach_mm);
    at_mm_[axis]->setDecimals(1);
    at_mm_[axis]->setSuffix(tr(" mm"));
    at_mm_[axis]->setValue(middle_mm[axis]);
    at_mm_[axis]->setToolTip(tr("The tip swings about this position, in the workspace frame W."));
    form->addRow(labels[axis], at_mm_[axis]);
  }
  more_ = new QCheckBox(tr("Also at &two more positions, to the left and to the right"), page);
  nameWidget(more_, "identify.places", tr("Also at two more positions"),
             tr("Shows whether the results depend on the position; takes three times as long."));
  form->addRow(more_);
  device_ = new QLineEdit(sentenceText(parts_.servo.device().title), page);
  nameWidget(device_, "identify.device", tr("Arm"), tr("Which arm this is; saved in the file."));
  form->addRow(tr("&Arm"), device_);
  serial_ = new QLineEdit(page);
  nameWidget(serial_, "identify.serial", tr("Serial number"), tr("As printed on the arm; optional."));
  form->addRow(tr("&Serial number"), serial_);
  page->addText("identify.rate", tr("The servo runs at %1 Hz.").arg(parts_.servo.rateHz()));
  page->column()->addStretch(1);
  return page;
}

identify::Wanted IdentifyWizard::wanted() const {
  identify::Wanted wanted;
  const Vec3 place_mm(at_mm_[0]->value(), at_mm_[1]->value(), at_mm_[2]->value());
  wanted.places_W = {kMetrePerMillimetre * place_mm};
  if (!more_->isChecked()) return wanted;
  for (const double side_mm : {-kAside_mm, kAside_mm})
    wanted.places_W.push_back(kMetrePerMillimetre * (place_mm + side_mm * Vec3::UnitX()));
  return wanted;
}

ProcedurePage* IdentifyWizard::measurePage() {
  measure_ = new ProcedurePage("identify.measure", tr("Measuring"), 12);
  prompt_ = measure_->addText("identify.prompt");
  auto* row = new QHBoxLayout;
  measure_->column()->addLayout(row);
  stage_ = measure_->addText("identify.stage");
  stage_->setAccessibleName(tr("Current part of the measurement"));
  progress_ = new QProgressBar(measure_);
  nameWidget(progress_, "identify.progress", tr("Progress"));
  progress_->setRange(0, 1000);
  measure_->column()->addWidget(progress_);
  why_ = measure_->addText("identify.why");
  why_->setAccessibleName(tr("Why the measurement has stopped"));
  why_->setProperty("role", "warning");
  plot_ = inTheme(theme_, new SwingPlot("identify.plot", measure_));
  measure_->column()->addWidget(plot_, 1);
  go_ = measure_->button("identify.go", tr("Con&tinue"),
                         tr("Starts this part. First take the stylus or let go of it, as the instruction says."));
  repeat_ = measure_->button("identify.repeat", tr("&Repeat this part"),
                             tr("Starts the servo again and repeats the interrupted part from its beginning."));
  row->addWidget(go_);
  row->addWidget(repeat_);
  row->addStretch(1);
  measure_->enter = [this] { begin(); };
  measure_->leave = [this] { run_.cancel(); };
  measure_->is_ready = [this] { return run_.state() == IdentifyRun::State::Done; };
  connect(go_, &QPushButton::clicked, &run_, &IdentifyRun::resume);
  connect(repeat_, &QPushButton::clicked, this,
          [this] { run_.state() == IdentifyRun::State::Stopped ? run_.repeat() : begin(); });
  connect(&run_, &IdentifyRun::changed, this, &IdentifyWizard::showState);
  connect(&run_, &IdentifyRun::progressed, this, &IdentifyWizard::showProgress);
  return measure_;
}

void IdentifyWizard::begin() {
  refused_.clear();
  plot_->present({});
  refused_ = sentencesOf(run_.begin(wanted()));
  showState();
}

void IdentifyWizard::showState() {
  using State = IdentifyRun::State;
  const State state = run_.state();
  prompt_->setText(run_.prompt());
  go_->setVisible(state == State::Asks && !run_.hasSimulatedPerson());
  const bool stands = state == State::Stopped || state == State::Failed || !refused_.isEmpty();
  repeat_->setVisible(stands);
  repeat_->setText(state == State::Stopped ? tr("&Repeat this part") : tr("&Begin again"));
  repeat_->setAccessibleName(repeat_->text().remove('&'));
  why_->setText(refused_.isEmpty() ? run_.why() : refused_);
  why_->setVisible(stands);
  showProgress();
  emit measure_->completeChanged();
}

void IdentifyWizard::showProgress() {
  stage_->setText(run_.stage());
  progress_->setValue(static_cast<int>(run_.share() * progress_->maximum()));
  const SwingPicture picture = run_.picture();
  if (!picture.measured.empty()) plot_->present(picture);
}

}  // namespace underact::gui
