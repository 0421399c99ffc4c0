#include "app/gui/kinematics/kinematics_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHideEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/kinematics/sections.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "app/gui/view/scene_view.h"
#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"

namespace underact::gui {
namespace {

constexpr const char* kLayers[] = {"layer.link_frames", "layer.ghosts", "layer.motion_ellipsoid",
                                   "layer.force_ellipsoid"};
constexpr double kShown_rad = 0.05 * kRadPerDegree;  // half a digit of what is shown
constexpr double kStill_rad = 1e-5;                  // from one frame to the next
constexpr std::int64_t kTravel_ns = 800'000'000;     // to a solution, as its ghost
constexpr std::int64_t kLongestMotion_ns = 3'000'000'000;
constexpr std::int64_t kRests_ns = 100'000'000;  // of servo time: the arm has come to rest

}  // namespace

KinematicsPanel::KinematicsPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  buildSwitches(column);
  column->addWidget(joints_ = new JointsSection(content));
  column->addWidget(singularities_ = new SingularitiesSection(content));
  column->addWidget(solutions_ = new SolutionsSection(content));
  column->addWidget(dh_ = new DhSection(content));
  column->addWidget(angles_ = new AnglesSection(content));
  column->addWidget(jacobian_ = new JacobianSection(content));
  column->addStretch(1);
  fillWithScroll(this, content);
  connect(joints_, &JointsSection::asked, this, [this](int joint, double deg) { setJoint(joint, deg, false); });
  connect(joints_, &JointsSection::stepped, this, [this](int joint, double deg) { setJoint(joint, deg, true); });
  connect(solutions_, &SolutionsSection::wanted, this, &KinematicsPanel::showSolution);
  connect(solutions_, &SolutionsSection::moveAsked, this, &KinematicsPanel::moveToSolution);
  connect(&parts_.document, &Document::opened, this, &KinematicsPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, [this] {
    if (!(scene::armOf(parts_.document.scene()).geometry == preset_.geometry)) sceneOpened();
  });
  sceneOpened();
  addActions();
}

void KinematicsPanel::addActions() {
  parts_.actions.add(
      {"view.kinematics", tr("&Kinematics with all layers"), QKeySequence("Alt+0"),
       tr("Opens the Kinematics panel and shows link frames, inverse solutions and both ellipsoids. Choose it again to "
          "hide them.")},
      [this](const QVariantList&) {
        const Layers& on = parts_.view.layers();
        return showAll(!(isVisible() && on.link_frames && on.ghosts && on.motion_ellipsoid && on.force_ellipsoid));
      });
  parts_.actions.addCommand("joint.set", [this](const QVariantList& values) {
    const int joint = values.value(0).toInt() - 1;
    return values.size() == 2 && joint >= 0 && setJoint(joint, values[1].toDouble(), false);
  });
  parts_.actions.addCommand("kinematics.hide_counts", [this](const QVariantList& on) {
    solutions_->hideCounts(on.value(0).toBool());
    return true;
  });
  parts_.actions.addCommand("solution.move", [this](const QVariantList& values) {  // from 1
    return moveToSolution(values.value(0).toInt());
  });
  parts_.actions.addCommand("solution.show", [this](const QVariantList& values) {  // from 1; 0: none
    const int number = values.value(0, -1).toInt();
    if (number < 0 || number > solutions_->max()) return false;
    if (solutions_->chosen() == number) return showSolution(number);
    solutions_->choose(number);
    return true;
  });
}

void KinematicsPanel::buildSwitches(QVBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  for (int index = 0; index < 4; ++index) {
    QAction* action = parts_.actions.find(kLayers[index]);
    auto* box = new QCheckBox(action->text(), this);
    nameWidget(box, QString("panel.kinematics.%1").arg(kLayers[index]),
               tr("%1, in the view").arg(action->text().remove('&')), action->toolTip());
    box->setChecked(action->isChecked());
    connect(box, &QCheckBox::toggled, this, [this, index](bool on) { parts_.actions.perform(kLayers[index], on); });
    connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
    grid->addWidget(box, index / 2, index % 2);
  }
  column->addLayout(grid);
  column->addWidget(scale_ = quietLabel("panel.kinematics.scale", QString(), this));
}

void KinematicsPanel::sceneOpened() {
  const arm::Preset& preset = scene::armOf(parts_.document.scene());
  model_ = scene::modelOf(parts_.document.scene());
  geometry_ = preset.geometry;
  limits_ = preset.limits;
  preset_ = preset;
  const bool is_named = arm::solvesInTick(geometry_);
  finder_ = SolutionFinder(model_);
  joints_->setArm(preset, model_);
  dh_->setArm(model_);
  jacobian_->setArm(preset, model_);
  solutions_->setArm(model_, is_named);
  singularities_->setVisible(is_named);
  angles_->setVisible(arm::isDevice(preset));
  if (is_named) singularities_->setReach(geometry_.upper_m + geometry_.fore_m);
  scale_->setText(tr("v: displacement of the tip for 0.25 rad of joint rotation. f: force for %1 N m.")
                      .arg(localNumber(ellipsoidTorque_N_m(preset_, model_), 'g', 3)));
  setpoint_.reset();
  shown_ns_ = -1;
}

bool KinematicsPanel::showAll(bool on) {
  for (const char* layer : kLayers) parts_.actions.perform(layer, on);
  parts_.actions.perform("dock.kinematics", on);
  return true;
}

bool KinematicsPanel::isDue(const servo::Snapshot& snapshot) {
  const std::int64_t now_ns = snapshot.report.sample.time_ns;
  const bool due =
      shown_ns_ < 0 || now_ns < shown_ns_ || now_ns - shown_ns_ >= kBetweenNumbers_ns || snapshot.mode != shown_mode_;
  if (!due) return false;
  shown_ns_ = now_ns;
  shown_mode_ = snapshot.mode;
  return true;
}

void KinematicsPanel::present(const servo::Snapshot& snapshot) {
  const arm::JointAngles& q_rad = snapshot.report.sample.q_rad;
  mode_ = snapshot.mode;
  if (snapshot.ticks == 0 || !std::all_of(q_rad.begin(), q_rad.end(), [](double q) { return std::isfinite(q); })) {
    return;
  }
  const std::int64_t now_ns = snapshot.report.sample.time_ns;
  const auto isStill = [](double before, double after) { return std::abs(after - before) < kStill_rad; };
  if (rests_ns_ < 0 || !std::equal(q_rad.begin(), q_rad.end(), q_rad_.begin(), isStill)) rests_ns_ = now_ns;
  q_rad_ = q_rad;
  travel(now_ns);
  settleArm(now_ns);
  if (!isSeen() || !isDue(snapshot)) return;
  const KinematicsNow now = kinematicsNow(preset_, finder_, q_rad);
  joints_->setMovable(
      parts_.player.isOpen()               ? tr("The replay moves the arm. Close the session to use the sliders.")
      : parts_.arms.simulated() == nullptr ? tr("A real arm is moved by hand: the sliders only show its joint angles.")
      : mode_ == servo::Mode::Idle         ? QString()
                                   : tr("The servo is running. Press Stop (Esc) to move the arm with the sliders."));
  joints_->present(now);
  joints_->setRemark(whyNotAsTyped());
  if (arm::solvesInTick(geometry_)) singularities_->present(now);
  angles_->present(now);
  solutions_->present(now);
  solutions_->setMovable(whyNotTo(solutions_->chosen()));
  dh_->present(now, model_);
  jacobian_->present(now);
}

bool KinematicsPanel::mayMove() const {
  return parts_.arms.simulated() != nullptr && !parts_.player.isOpen() && mode_ == servo::Mode::Idle;
}

/// Whether the arm is still where it was commanded to, or on its way there.
bool KinematicsPanel::leadsArm() const {
  if (!mayMove() || !setpoint_ || travel_) return false;
  const sim::HandSetpoint& last = parts_.arms.simulated()->setpoint();
  return last.p_WT == setpoint_->p_WT && last.R_WT == setpoint_->R_WT && last.turns &&
         last.posture == setpoint_->posture;
}

/// Friction stops the arm a little short of what was typed: once it rests it is put there.
void KinematicsPanel::settleArm(std::int64_t now_ns) {
  if (commanded_ns_ < 0) commanded_ns_ = now_ns;
  const bool moves = now_ns - rests_ns_ < kRests_ns && now_ns - commanded_ns_ < kLongestMotion_ns;
  if (is_settled_ || !leadsArm() || moves) return;
  is_settled_ = true;
  parts_.arms.simulated()->standAt(setpoint_rad_);
  parts_.arms.simulated()->setSetpoint(*setpoint_);
}

/// Of the joint whose encoder cannot show what was asked for; empty: all do.
QString KinematicsPanel::whyNotAsTyped() const {
  if (!is_settled_ || !leadsArm()) return {};
  for (std::size_t joint = 0; joint < model_.rows.size(); ++joint) {
    const double step = 2.0 * kPi / preset_.counts_per_turn[joint];
    const bool slides = model_.rows[joint].type == chain::JointType::Prismatic;
    if (slides || !std::isfinite(step) || std::abs(q_rad_[joint] - setpoint_rad_[joint]) < kShown_rad) continue;
    return tr("The encoder of joint %1 has steps of %2°: this is the nearest one.")
        .arg(joint + 1)
        .arg(numberText(step / kRadPerDegree, 2));
  }
  return {};
}

bool KinematicsPanel::setJoint(int joint, double angle_deg, bool relative) {
  if (!mayMove()) return false;
  travel_.reset();
  arm::JointAngles q_rad = leadsArm() ? setpoint_rad_ : q_rad_;
  const auto index = static_cast<std::size_t>(joint);
  if (index >= model_.rows.size()) return false;
  double& moved_rad = q_rad[index];
  const bool slides = model_.rows[index].type == chain::JointType::Prismatic;
  const double value = angle_deg * (slides ? kMetrePerMillimetre : kRadPerDegree);
  moved_rad = relative ? moved_rad + value : value;
  moveArm(q_rad);
  return true;
}

/// Why the arm does not move to that solution; empty: it does.
QString KinematicsPanel::whyNotTo(int number) const {
  const NumberedSolution* const found = solutions_->find(number);
  if (parts_.player.isOpen()) return tr("The replay moves the arm. Close the session to move it here.");
  if (parts_.arms.simulated() == nullptr) return tr("A real arm is moved by hand.");
  if (mode_ != servo::Mode::Idle) return tr("The servo is running. Press Stop (Esc) to move the arm.");
  if (found == nullptr) return tr("Solution %1 does not exist here.").arg(number);
  return found->within_limits ? QString() : tr("Solution %1 is outside the joint limits.").arg(number);
}

bool KinematicsPanel::moveToSolution(int number) {
  if (!whyNotTo(number).isEmpty()) return false;
  travel_ = Travel{q_rad_, solutions_->find(number)->q};
  return true;
}

/// A frame of the way to a solution: its joints move evenly, whatever their masses.
void KinematicsPanel::travel(std::int64_t now_ns) {
  if (!travel_) return;
  if (!mayMove()) return travel_.reset();
  if (travel_->began_ns < 0) travel_->began_ns = now_ns;
  const double share = std::min(1.0, static_cast<double>(now_ns - travel_->began_ns) / static_cast<double>(kTravel_ns));
  parts_.arms.simulated()->standAt(arm::interpolated(travel_->from, travel_->to, share));
  if (share < 1.0) return;
  const arm::JointAngles there = travel_->to;
  travel_.reset();
  moveArm(there);
  is_settled_ = true;
}

void KinematicsPanel::moveArm(const arm::JointAngles& q_rad) {
  device::SimulatedArm* const arm = parts_.arms.simulated();
  setpoint_rad_ = arm::withinLimits(limits_, q_rad);
  const Pose X_WT = arm::tipPose(geometry_, setpoint_rad_);
  setpoint_ = sim::HandSetpoint{X_WT.translation(), Vec3::Zero(), X_WT.linear(), true, true, setpoint_rad_};
  arm->setSetpoint(*setpoint_);
  is_settled_ = false;
  rests_ns_ = commanded_ns_ = -1;
}

bool KinematicsPanel::showSolution(int number) {
  parts_.view.chooseSolution(number);
  solutions_->setMovable(whyNotTo(number));
  return true;
}

void KinematicsPanel::hideEvent(QHideEvent* event) {
  Panel::hideEvent(event);
  if (event->spontaneous()) return;  // the whole window was hidden
  solutions_->choose(0);             // its ghost is meaningless without the panel
  shown_ns_ = -1;
}

void KinematicsPanel::setTheme(const Theme& theme) {
  singularities_->setTheme(theme);
}

}  // namespace underact::gui
