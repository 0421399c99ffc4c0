#include "app/gui/registration/registration_tool.h"

#include <QAction>
#include <QDate>
#include <QMainWindow>

#include "app/gui/arms/second_arm.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/remark.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/document.h"
#include "app/gui/registration/registration_wizard.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"
#include "core/registration/error.h"
#include "core/registration/registration_store.h"
#include "device/arm_key.h"
#include "device/chosen_arm.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

using registration::Registration;

/// The pose of the second arm in the frame of the first: X_WS = X_DW^-1 X_DS.
std::optional<Pose> placeOfSecondArm(const std::optional<Registration>& first,
                                     const std::optional<Registration>& second) {
  if (!first || !second) return {};
  return Pose(first->fit.X_DW.inverse() * second->fit.X_DW);
}

}  // namespace

RegistrationTool::RegistrationTool(const FeatureParts& parts) : QObject(parts.window), parts_(parts), run_(this) {
  connect(this, &RegistrationTool::changed, this, [this] { parts_.where_it_stands.say(sentence(Which::First)); });
  parts_.actions.add(
      {"registration.open",
       tr("Re&gister the arm…"),
       {},
       tr("Finds the pose of the arm on the desk from reference points that its tip touches, step by step.")},
      [this](const QVariantList&) {
        openProcedure(wizard_, *this, parts_.theme, parts_.window);
        return true;
      });
  parts_.actions.addCommand("registration.forget", [this](const QVariantList& second) {
    return forget(second.value(0).toBool() ? Which::Second : Which::First).empty();
  });
  parts_.actions.addCommand("registration.touch", [this](const QVariantList&) {
    run_.press();
    return run_.isOn() && run_.touching().isHolding();
  });
  parts_.actions.addCommand("registration.sheet", [this](const QVariantList& path) {
    return wizard_ && wizard_->saveSheet(path.value(0).toString());
  });
  connect(&parts_.arms, &ArmChoice::changed, this, &RegistrationTool::recallAll);
  connect(&parts_.second, &SecondArm::changed, this, [this] {  // our own changes emit it as well
    if (keyOf(Which::Second) != known_[1].arm) recallAll();
  });
  recallAll();
}

RegistrationTool::~RegistrationTool() {
  delete wizard_;
}

bool RegistrationTool::hasSecond() const {
  return parts_.second.isOn();
}

bool RegistrationTool::isSimulated(Which which) const {
  return which == Which::First ? parts_.servo.device().simulated : parts_.second.arms().simulated() != nullptr;
}

std::string RegistrationTool::keyOf(Which which) const {
  if (which == Which::Second) {
    if (!hasSecond()) return {};
    // A simulated second arm must not share the key of the first.
    if (isSimulated(which)) return "simulated:second";
    return device::armKey(parts_.second.arms().name().toStdString(), parts_.second.servo().device());
  }
  const bool by_name = parts_.chosen != nullptr;
  return device::armKey(by_name ? parts_.arms.name().toStdString() : std::string(),
                        by_name ? parts_.chosen->info() : parts_.servo.device());
}

void RegistrationTool::recallAll() {
  if (wizard_ && run_.isOn()) wizard_->close();  // the run was of another arm
  for (const Which which : {Which::First, Which::Second}) {
    Known known{keyOf(which), {}, {}};
    if (!known.arm.empty()) {
      auto found = registration::loadRegistration(known.arm, registration::registrationFolder());
      if (found)
        known.registration = std::move(found).value();
      else
        known.refusal = sentencesOf(found.problems());
    }
    known_[index(which)] = std::move(known);
  }
  place();
  emit changed();
}

void RegistrationTool::place() {
  std::optional<Desk> desk;
  if (const auto& first = of(Which::First))
    desk = Desk{first->fit.X_DW.inverse(), registration::referencePointsOf(first->touches)};
  parts_.view.setDesk(desk);
  const std::optional<Pose> X_WS = placeOfSecondArm(of(Which::First), of(Which::Second));
  if (X_WS || parts_.second.placed()) parts_.second.setPlace(X_WS);
}

QString RegistrationTool::title(Which which) const {
  if (which == Which::First) return sentenceText(parts_.servo.device().title);
  return tr("Second arm: %1").arg(sentenceText(parts_.second.servo().device().title));
}

QString RegistrationTool::trouble(Which which) const {
  if (which == Which::Second && !hasSecond()) return {};
  return sentenceText(which == Which::First ? parts_.servo.trouble() : parts_.second.servo().trouble());
}

QString RegistrationTool::refusalReason() const {
  if (parts_.document.showsRecorded()) return tr("A recording is being replayed. Close it, then register the arm.");
  if (parts_.document.isTryingOut()) return tr("A measurement is running on this arm. End it, then register the arm.");
  return parts_.document.isOpen() ? QString()
                                  : tr("No scene is open. Open one, so that the position of the tip is known.");
}

QString RegistrationTool::sentence(Which which) const {
  const Known& known = known_[index(which)];
  if (!known.refusal.isEmpty()) return tr("Not registered: %1").arg(known.refusal);
  if (!known.registration) return tr("Not registered: the view shows the arm as if it stood straight.");
  const registration::ErrorInTheMiddle middle = errorInTheMiddle(known.registration->touches, known.registration->fit);
  return tr("Registered on %1 with %2 reference points, residual %3 mm. Expected error at the centre of the workspace: "
            "%4 mm.")
      .arg(QString::fromStdString(known.registration->date))
      .arg(known.registration->touches.size())
      .arg(numberText(kMillimetrePerMetre * known.registration->fit.rms_m, 2),
           numberText(kMillimetrePerMetre * middle.expected_m, 2));
}

void RegistrationTool::begin(Which which, std::vector<Vec3> points_D) {
  parts_.actions.perform("session.stop");  // nothing may pull at the tip while it rests
  which_ = which;
  parts_.second.setListener(which == Which::Second ? [this](const servo::TickRecord& record) { run_.add(record); }
                                                   : std::function<void(const servo::TickRecord&)>());
  run_.begin(std::move(points_D));
}

void RegistrationTool::stopTouching() {
  parts_.second.setListener({});
  run_.end();
}

Problems RegistrationTool::accept() {
  if (!run_.isOn()) return {{phrase(QT_TRANSLATE_NOOP("problem", "No reference point has been touched.")), {}}};
  const Result<registration::Fit> fit = run_.fit();
  if (!fit) return fit.problems();
  Registration made{keyOf(which_), QDate::currentDate().toString(Qt::ISODate).toStdString(),
                    std::string("underact ") + kVersion, run_.touching().touches(), fit.value()};
  const Problems problems = registration::saveRegistration(made, registration::registrationFolder());
  known_[index(which_)] = {made.arm, std::move(made), {}};
  place();
  emit changed();
  return problems;
}

Problems RegistrationTool::forget(Which which) {
  Known& known = known_[index(which)];
  const Problems problems = registration::removeRegistration(known.arm, registration::registrationFolder());
  if (!problems.empty()) return problems;
  known.registration.reset();
  known.refusal.clear();
  place();
  emit changed();
  return {};
}

void RegistrationTool::add(const servo::TickRecord& record) {
  if (which_ == Which::First) run_.add(record);
}

void RegistrationTool::poll(const servo::Snapshot&) {
  if (wizard_) wizard_->poll();
}

}  // namespace underact::gui
