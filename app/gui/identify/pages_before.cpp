// The pages of the wizard up to the measurement.
#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/identify/pages.h"
#include "app/gui/identify/swing_plot.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kReach_mm = 200.0;
constexpr double kAside_mm = 20.0;  // of the two more positions, to the left and right of the first

QLabel* words(const char* name, const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  return label;
}

QVBoxLayout* columnOf(QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setSpacing(12);
  return column;
}

}  // namespace

IntroPage::IntroPage(bool simulated_person, QWidget* parent) : QWizardPage(parent) {
  setObjectName("identify.intro");
  setTitle(tr("Measure the arm"));
  QVBoxLayout* column = columnOf(this);
  column->addWidget(words(
      "identify.what",
      tr("This wizard measures the arm: the mass, friction and damping at its tip along x, y and z, the resolution of "
         "its encoders, and the stiffness that it actually renders. At the end you can save an arm file and a report."),
      this));
  column->addWidget(
      words("identify.hand",
            simulated_person
                ? tr("The arm is simulated, and a simulated hand follows the instructions. This takes half a minute.")
                : tr("First let go of the stylus: for about 20 seconds the arm moves it by itself, 20 mm to each side, "
                     "with no more force than any scene may use. Then take the stylus, press it down slowly, and "
                     "rotate it. This takes about a minute."),
            this));
  column->addWidget(
      words("identify.safety", tr("Esc stops the force at any time. The open scene is restored afterwards."), this));
  column->addStretch(1);
}

PlacePage::PlacePage(int rate_hz, const QString& device, QWidget* parent)
    : QWizardPage(parent),
      more_(new QCheckBox(tr("Also at &two more positions, to the left and to the right"), this)),
      device_(new QLineEdit(device, this)),
      serial_(new QLineEdit(this)) {
  setObjectName("identify.where");
  setTitle(tr("Position and arm"));
  auto* form = new QFormLayout;
  const double middle_mm[] = {0.0, 0.0, 60.0};
  const QString labels[] = {tr("Position &x"), tr("Position &y"), tr("Position &z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at_mm_[axis] = new NumberBox(this);
    at_mm_[axis]->setObjectName(QString("identify.place.%1").arg(QLatin1Char("xyz"[axis])));
    at_mm_[axis]->setAccessibleName(QString(labels[axis]).remove('&'));
    at_mm_[axis]->setRange(-kReach_mm, kReach_mm);
    at_mm_[axis]->setDecimals(1);
    at_mm_[axis]->setSuffix(tr(" mm"));
    at_mm_[axis]->setValue(middle_mm[axis]);
    at_mm_[axis]->setToolTip(tr("The tip swings about this position, in the workspace frame W."));
    form->addRow(labels[axis], at_mm_[axis]);
  }
  nameWidget(more_, "identify.places", tr("Also at two more positions"),
             tr("Shows whether the results depend on the position; takes three times as long."));
  form->addRow(more_);
  nameWidget(device_, "identify.device", tr("Arm"), tr("Which arm this is; saved in the file."));
  form->addRow(tr("&Arm"), device_);
  nameWidget(serial_, "identify.serial", tr("Serial number"), tr("As printed on the arm; optional."));
  form->addRow(tr("&Serial number"), serial_);
  QVBoxLayout* column = columnOf(this);
  column->addLayout(form);
  column->addWidget(words("identify.rate", tr("The servo runs at %1 Hz.").arg(rate_hz), this));
  column->addStretch(1);
}

identify::Wanted PlacePage::wanted() const {
  identify::Wanted wanted;
  const Vec3 place_mm(at_mm_[0]->value(), at_mm_[1]->value(), at_mm_[2]->value());
  wanted.places_W = {kMetrePerMillimetre * place_mm};
  if (!more_->isChecked()) return wanted;
  for (const double side_mm : {-kAside_mm, kAside_mm})
    wanted.places_W.push_back(kMetrePerMillimetre * (place_mm + side_mm * Vec3::UnitX()));
  return wanted;
}

QString PlacePage::device() const {
  return device_->text();
}

QString PlacePage::serial() const {
  return serial_->text();
}

MeasurePage::MeasurePage(IdentifyRun& run, const PlacePage& place, QWidget* parent)
    : QWizardPage(parent),
      run_(run),
      place_(place),
      prompt_(words("identify.prompt", {}, this)),
      stage_(words("identify.stage", {}, this)),
      why_(words("identify.why", {}, this)),
      progress_(new QProgressBar(this)),
      plot_(new SwingPlot("identify.plot", this)),
      go_(new QPushButton(tr("Con&tinue"), this)),
      repeat_(new QPushButton(tr("&Repeat this part"), this)) {
  setObjectName("identify.measure");
  setTitle(tr("Measuring"));
  stage_->setAccessibleName(tr("Current part of the measurement"));
  why_->setAccessibleName(tr("Why the measurement has stopped"));
  why_->setProperty("role", "warning");
  nameWidget(progress_, "identify.progress", tr("Progress"));
  progress_->setRange(0, 1000);
  for (const auto& [button, name] : {std::pair{go_, "identify.go"}, {repeat_, "identify.repeat"}}) {
    nameWidget(button, name, button->text().remove('&'));
  }
  go_->setToolTip(tr("Starts this part. First take the stylus or let go of it, as the instruction says."));
  repeat_->setToolTip(tr("Starts the servo again and repeats the interrupted part from its beginning."));
  auto* row = new QHBoxLayout;
  row->addWidget(go_);
  row->addWidget(repeat_);
  row->addStretch(1);
  QVBoxLayout* column = columnOf(this);
  column->addWidget(prompt_);
  column->addLayout(row);
  column->addWidget(stage_);
  column->addWidget(progress_);
  column->addWidget(why_);
  column->addWidget(plot_, 1);
  connect(go_, &QPushButton::clicked, &run_, &IdentifyRun::resume);
  connect(repeat_, &QPushButton::clicked, this,
          [this] { run_.state() == IdentifyRun::State::Stopped ? run_.repeat() : begin(); });
  connect(&run_, &IdentifyRun::changed, this, &MeasurePage::showState);
  connect(&run_, &IdentifyRun::progressed, this, &MeasurePage::showProgress);
}

void MeasurePage::initializePage() {
  begin();
}

void MeasurePage::cleanupPage() {
  run_.cancel();
}

bool MeasurePage::isComplete() const {
  return run_.state() == IdentifyRun::State::Done;
}

void MeasurePage::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void MeasurePage::begin() {
  refused_.clear();
  plot_->present({});
  const Problems problems = run_.begin(place_.wanted());
  refused_ = sentencesOf(problems);
  showState();
}

void MeasurePage::showState() {
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
  emit completeChanged();
}

void MeasurePage::showProgress() {
  stage_->setText(run_.stage());
  progress_->setValue(static_cast<int>(run_.share() * progress_->maximum()));
  const SwingPicture picture = run_.picture();
  if (!picture.measured.empty()) plot_->present(picture);
}

}  // namespace underact::gui
