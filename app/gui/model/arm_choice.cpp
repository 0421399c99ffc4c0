#include "app/gui/model/arm_choice.h"

#include <algorithm>
#include <utility>

#include "app/gui/model/document.h"
#include "core/arm/preset.h"
#include "core/scene/scene_arm.h"
#include "device/catalogue.h"
#include "device/chosen_arm.h"

namespace underact::gui {
namespace {

constexpr int kPollTrial_ms = 30;
constexpr const char* kSimulated = "simulated";

}  // namespace

ArmChoice::ArmChoice(servo::Host& host, Document& document, device::ChosenArm* chosen, device::SimulatedArm* simulated,
                     QObject* parent)
    : QObject(parent), host_(host), document_(document), chosen_(chosen), simulated_(simulated) {
  poll_timer_.setInterval(kPollTrial_ms);
  connect(&poll_timer_, &QTimer::timeout, this, &ArmChoice::poll);
  connect(&document_, &Document::opened, this, &ArmChoice::sceneOpened);
  connect(&document_, &Document::edited, this, &ArmChoice::sceneOpened);
}

ArmChoice::~ArmChoice() = default;

device::SimulatedArm* ArmChoice::simulated() const {
  return chosen_ == nullptr || chosen_->isFirst() ? simulated_ : nullptr;
}

Problems ArmChoice::refusalNow() const {
  if (chosen_ == nullptr)
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "This window was opened for one arm only.")), {}}};
  if (host_.records())
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem",
                                              "A session is being recorded, and a session contains only one arm. Stop "
                                              "the recording, then choose the arm.")),
                     {}}};
  if (document_.showsRecorded())
    return Problems{
        {phrase(QT_TRANSLATE_NOOP("problem", "A session is being replayed. Close it, then choose the arm.")), {}}};
  if (document_.isTryingOut())
    return Problems{
        {phrase(QT_TRANSLATE_NOOP("problem", "A measurement is running on this arm. End it, then choose the arm.")),
         {}}};
  return {};
}

Problems ArmChoice::choose(const QString& name) {
  Problems problems = refusalNow();
  if (!problems.empty()) return problems;
  cancel();
  wanted_ = name;
  putFirst();
  if (name == kSimulated) {
    emit changed();
    return {};
  }
  arm_ = scene::armTextOf(document_.scene());
  opening_ = name;
  const device::Request request{scene::armOf(document_.scene()), {}, host_.rateHz(), {}};
  work_ = std::make_unique<Background<Opened>>(
      [request, key = name.toStdString()](WorkState&) { return device::openDevice(key, request); });
  poll_timer_.start();
  emit began();
  return {};
}

/// Closes the current arm, which may be the one to be opened next, and puts the simulated one in its place.
void ArmChoice::putFirst() {
  name_ = kSimulated;
  if (chosen_->isFirst()) return;
  chosen_->choose(nullptr);
  host_.restart();
}

void ArmChoice::cancel() {
  if (work_ == nullptr) return;
  work_->cancel();
  wanted_ = name_;
  leaving_.push_back(std::move(work_));
  opening_.clear();
  emit changed();
}

void ArmChoice::poll() {
  leaving_.erase(std::remove_if(leaving_.begin(), leaving_.end(), [](auto& one) { return one->take().has_value(); }),
                 leaving_.end());
  if (std::optional<Opened> opened = work_ ? work_->take() : std::nullopt) {
    work_.reset();
    const QString name = std::exchange(opening_, QString());
    Problems problems = *opened ? refusalNow() : opened->problems();  // a recording may have started meanwhile
    if (problems.empty()) {
      chosen_->choose(std::move(*opened).value());
      problems = host_.restart();
      name_ = name;
      emit changed();
    } else {
      emit changed();
      emit failed(name, problems);
    }
  }
  if (work_ == nullptr && leaving_.empty()) poll_timer_.stop();
}

/// An arm is opened with the kinematics of the scene's arm.
void ArmChoice::sceneOpened() {
  if (document_.showsRecorded() || scene::armTextOf(document_.scene()) == arm_) return;
  const QString wanted = opening_.isEmpty() ? name_ : opening_;
  if (wanted == kSimulated) return;
  const Problems problems = choose(wanted);
  if (problems.empty()) return;
  host_.stop();  // otherwise it would be driven with the kinematics of another arm
  emit failed(wanted, problems);
}

}  // namespace underact::gui
