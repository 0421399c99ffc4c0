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
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/panel_scroll.h"
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
  column->addWidget(quietLabel("panel.kinematics.scale",
                               tr("v: displacement of the tip for 0.25 rad of joint rotation. f: force for 0.05 N m."),
                               this));
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
  q_rad_ = q_rad;
  if (!isSeen() || !isDue(snapshot)) return;
  const KinematicsNow now = kinematicsNow(preset_, finder_, q_rad);
  joints_->setMovable(
      parts_.player.isOpen()               ? tr("The replay moves the arm. Close the session to use the sliders.")
      : parts_.arms.simulated() == nullptr ? tr("A real arm is moved by hand: the sliders only show its joint angles.")
      : mode_ == servo::Mode::Idle         ? QString()
                                   : tr("The servo is running. Press Stop (Esc) to move the arm with the sliders."));
  joints_->present(now);
  if (arm::solvesInTick(geometry_)) singularities_->present(now);
  angles_->present(now);
  solutions_->present(now);
  dh_->present(now, model_);
  jacobian_->present(now);
}

bool KinematicsPanel::setJoint(int joint, double angle_deg, bool relative) {
  device::SimulatedArm* const arm = parts_.arms.simulated();
  if (arm == nullptr || parts_.player.isOpen() || mode_ != servo::Mode::Idle) return false;
  const sim::HandSetpoint& last = arm->setpoint();
  const bool is_ours = setpoint_ && last.p_WT == setpoint_->p_WT && last.R_WT == setpoint_->R_WT && last.turns &&
                       last.posture == setpoint_->posture;
  arm::JointAngles q_rad = is_ours ? setpoint_rad_ : q_rad_;
  const auto index = static_cast<std::size_t>(joint);
  if (index >= model_.rows.size()) return false;
  double& moved_rad = q_rad[index];
  const bool slides = model_.rows[index].type == chain::JointType::Prismatic;
  const double value = angle_deg * (slides ? kMetrePerMillimetre : kRadPerDegree);
  moved_rad = relative ? moved_rad + value : value;
  setpoint_rad_ = arm::withinLimits(limits_, q_rad);
  const Pose X_WT = arm::tipPose(geometry_, setpoint_rad_);
  setpoint_ = sim::HandSetpoint{X_WT.translation(), Vec3::Zero(), X_WT.linear(), true, true, setpoint_rad_};
  arm->setSetpoint(*setpoint_);
  return true;
}

bool KinematicsPanel::showSolution(int number) {
  parts_.view.chooseSolution(number);
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
