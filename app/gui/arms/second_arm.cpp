#include "app/gui/arms/second_arm.h"

#include <utility>

#include "app/gui/kit/words.h"
#include "app/gui/model/fault_folder.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"
#include "core/record/fault_file.h"
#include "core/scene/mirror.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

constexpr double kApart_mm = 260.0;  // between the centres of the workspaces: neither arm reaches into the other's

sim::HandSetpoint mirrored(sim::HandSetpoint setpoint, const arm::MirrorPlane& plane) {
  const Vec3 flip = plane.directionSeen(Vec3::Ones());
  setpoint.p_WT = plane.positionSeen(setpoint.p_WT);
  setpoint.v_WT = plane.directionSeen(setpoint.v_WT);
  setpoint.R_WT = (flip.asDiagonal() * setpoint.R_WT * flip.asDiagonal()).eval();  // still a rotation
  setpoint.posture.reset();  // the mirror image of its joints is not known: the tip is led
  return setpoint;
}

}  // namespace

SecondArm::SecondArm(ServoFacts first, ArmChoice& first_arms, SceneView& view, QObject* parent)
    : QObject(parent), first_(first), first_arms_(first_arms), view_(view) {}

SecondArm::~SecondArm() {
  end();
}

void SecondArm::setOn(bool on) {
  if (on == isOn()) return;
  if (on)
    begin();
  else
    end();
  emit changed();
}

void SecondArm::begin() {
  const bool by_hand = first_.scheduling().name == "manual";
  simulated_ = makeSimulatedHost({.rate_hz = first_.rateHz(),
                                  .clock = by_hand ? servo::Clock::Manual : servo::Clock::Thread,
                                  .scheduling = first_.schedulingWanted(),
                                  .max_late = first_.maxLate()});
  setReached(true);
  document_ = std::make_unique<Document>(*simulated_.host);
  arms_ = std::make_unique<ArmChoice>(*simulated_.host, *document_, simulated_.chosen, simulated_.arm, nullptr);
  connect(arms_.get(), &ArmChoice::began, this, &SecondArm::changed);
  connect(arms_.get(), &ArmChoice::changed, this, &SecondArm::changed);
  connect(arms_.get(), &ArmChoice::failed, this, [this](const QString& name, const Problems& problems) {
    emit told(tr("“%1” was not opened. %2").arg(name, sentencesOf(problems)));
  });
  connect(document_.get(), &Document::opened, this, [this] {
    view_.showSecond(document_->scene());
    place();
    if (first_.running() && arms_->simulated() != nullptr) start();  // nobody holds a simulated arm
    emit changed();
  });
  openScene(path_.isEmpty() ? firstScene(shippedScenes()) : path_);
}

void SecondArm::end() {
  if (!isOn()) return;
  view_.hideSecond();
  loading_.cancel();
  simulated_.host->stop();
  setReached(false);
  arms_.reset();
  document_.reset();
  simulated_ = {};  // the arm gets zero force, and is closed
}

Problems SecondArm::choose(const QString& name) {
  if (name != "simulated" && name == first_arms_.name())
    return Problems{{phrase(QT_TRANSLATE_NOOP(
                         "problem", "This arm is already in use as the first arm. Choose another one here or there.")),
                     {}}};
  return arms_->choose(name);
}

void SecondArm::openScene(const QString& path) {
  path_ = path;
  if (!isOn() || path.isEmpty()) return;
  const Problems problems = loading_.begin(path);
  if (!problems.empty()) return emit told(tr("The scene is unchanged. %1").arg(sentencesOf(problems)));
  takeScene();
  if (isLoading()) emit changed();
}

void SecondArm::takeScene() {
  std::optional<SceneLoading::Loaded> loaded = loading_.take();
  if (!loaded) return;
  if (loaded->problems.empty()) loaded->problems = document_->open(std::move(loaded->scene));
  if (loaded->problems.empty()) simulated_.arm->become(scene::armOf(document_->scene()));
  if (!loaded->problems.empty()) emit told(tr("The scene is unchanged. %1").arg(sentencesOf(loaded->problems)));
  emit changed();
}

void SecondArm::setSide(Side side) {
  side_ = side;
  place();
}

void SecondArm::setPlace(const std::optional<Pose>& X_WS) {
  X_WS_ = X_WS;
  place();
  emit changed();
}

void SecondArm::place() {
  if (!isOn()) return;
  Pose X_WS_mm = Pose::Identity();
  X_WS_mm.translation().x() = side_ == Side::Left ? -kApart_mm : kApart_mm;
  if (X_WS_) {
    X_WS_mm = *X_WS_;
    X_WS_mm.translation() *= kMillimetrePerMetre;
  }
  view_.placeSecond(X_WS_mm);
}

void SecondArm::start() {
  if (isOn() && document_->isOpen()) simulated_.host->start();
}

void SecondArm::stop() {
  if (isOn()) simulated_.host->stop();
}

void SecondArm::setReached(bool on) {
  const std::scoped_lock lock(mutex_);
  is_reached_ = on;
}

void SecondArm::stopFromAnyThread() {
  const std::scoped_lock lock(mutex_);
  if (is_reached_) ++simulated_.host->stops();
}

void SecondArm::reportBusyWindow(std::int64_t pause_ns) {
  const std::scoped_lock lock(mutex_);
  if (is_reached_) simulated_.host->reportBusyWindow(pause_ns);
}

void SecondArm::setRate(int rate_hz) {
  if (!isOn()) return;
  const Problems problems = simulated_.host->setRate(rate_hz);
  if (!problems.empty()) emit told(tr("The rate of the second arm is unchanged. %1").arg(sentencesOf(problems)));
}

void SecondArm::takeFaults() {
  while (const std::optional<servo::FaultReport> report = simulated_.host->takeFault()) {
    const record::FaultWords words = record::wordsOf(*report);
    const Result<std::string> kept = record::saveFault(*report, words, faultFolder().toStdString());
    emit told(tr("The second arm: %1 %2").arg(sentenceText(words.what), sentenceText(words.what_to_do)) +
              (kept ? tr(" The report is in %1.").arg(QString::fromStdString(kept.value())) : QString()));
  }
}

/// The hand of a simulated arm mirrors the first one.
void SecondArm::moveHand() {
  if (!mirrors_ || arms_->simulated() == nullptr) return;
  const arm::MirrorPlane plane = scene::mirrorPlaneOf(document_->scene());
  if (const device::SimulatedArm* hand = first_arms_.simulated()) {
    simulated_.arm->glideTo(mirrored(hand->setpoint(), plane));
    return;
  }
  const tick::TickReport report = first_.snapshot().report;
  if (report.p_WT.allFinite())
    simulated_.arm->glideTo(mirrored({report.p_WT, Vec3::Zero(), Mat3::Identity(), false}, plane));
}

void SecondArm::poll() {
  if (!isOn()) return;
  takeScene();
  if (simulated_.host->holdToRun() != first_.holdToRun()) simulated_.host->setHoldToRun(first_.holdToRun());
  moveHand();
  const servo::Snapshot snapshot = simulated_.host->snapshot();
  simulated_.host->drain([this](const servo::TickRecord& record) {
    if (listener_) listener_(record);
  });
  takeFaults();
  if (snapshot.ticks > 0) view_.presentSecond(snapshot);
}

}  // namespace underact::gui
