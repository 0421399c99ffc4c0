#include "app/gui/feel/feel_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/gui/feel/guide_section.h"
#include "app/gui/feel/influence_section.h"
#include "app/gui/feel/rate_section.h"
#include "app/gui/feel/surface_section.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/gain_row.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/stability.h"
#include "core/scene/edit.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

std::optional<scene::CurveGuide> guideOf(const scene::Constraint& constraint) {
  const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
  return curve == nullptr ? std::nullopt : curve->guide;
}

std::optional<double> smoothingOf(const scene::Constraint& constraint) {
  const auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape);
  return mesh == nullptr ? std::nullopt : std::optional(mesh->smooth_deg);
}

Vec3& gainOf(scene::Gains& gains, int gain) {
  return gain == 0 ? gains.kp_N_per_mm : gain == 1 ? gains.kd_N_s_per_mm : gains.ki_N_per_mm_s;
}
bool allEqual(const Vec3& v) {
  return v.x() == v.y() && v.y() == v.z();
}

/// "x", or "q1" where the control works on the joints.
QString axisName(const scene::Control& control, int axis) {
  return control.space == tick::Space::Joint ? QString("q%1").arg(axis + 1) : QString(QChar('x' + axis));
}

}  // namespace

bool FeelPanel::hasScene() const {
  return !parts_.document.scene().constraints.empty();
}

void FeelPanel::addActions() {
  parts_.actions.add({"gains.reset", tr("Reset to &scene"), QKeySequence("Ctrl+R"),
                      tr("Puts gains, influence and friction back to those of the scene's file."), "reset"},
                     [this](const QVariantList&) { return resetToScene(); });
  parts_.actions.addCommand("gains.set", [this](const QVariantList& values) {
    if (values.size() != 3) return false;
    const auto gain = static_cast<int>(QStringList{"kp", "kd", "ki"}.indexOf(values[0].toString()));
    const auto axis = static_cast<int>(QStringList{"x", "y", "z"}.indexOf(values[1].toString()));
    return gain >= 0 && axis >= 0 && setGain(gain, axis, values[2].toDouble(), true);
  });
  parts_.actions.addCommand("law.set", [this](const QVariantList& values) {
    const auto law = static_cast<int>(QStringList{"P", "PD", "PID"}.indexOf(values.value(0).toString()));
    return law >= 0 && setLaw(static_cast<scene::LawType>(law));
  });
  parts_.actions.addCommand("space.set", [this](const QVariantList& values) {
    const auto space = static_cast<int>(QStringList{"cartesian", "joint"}.indexOf(values.value(0).toString()));
    return space >= 0 && setSpace(static_cast<tick::Space>(space));
  });
  parts_.actions.addCommand("passivity.set", [this](const QVariantList& values) {
    for (const auto& word : scene::kPassivityWords) {
      if (values.value(0).toString() == word.word) return setPassivity(word.value);
    }
    return false;
  });
}

void FeelPanel::addInfluenceCommands() {
  parts_.actions.addCommand("influence.set", [this](const QVariantList& values) {
    if (values.size() != 1 || !hasScene()) return false;
    std::optional<scene::Influence> wanted = parts_.document.scene().constraints[index_].influence;
    if (!wanted) return false;
    wanted->t = values[0].toDouble();
    return setInfluence(wanted, tr("influence t"), true);
  });
  parts_.actions.addCommand("influence.on", [this](const QVariantList& values) {
    const bool on = values.value(0).toBool();
    if (!hasScene() || on == parts_.document.scene().constraints[index_].influence.has_value()) return hasScene();
    return setInfluence(influence_->switched(on), on ? tr("influence on") : tr("influence off"), true);
  });
}

void FeelPanel::addSurfaceCommands() {
  parts_.actions.addCommand("friction.set", [this](const QVariantList& shares) {
    if (shares.size() != 2) return false;
    return setFriction(scene::Friction{shares[0].toDouble(), shares[1].toDouble()}, tr("friction"), true);
  });
  parts_.actions.addCommand("friction.on", [this](const QVariantList& values) {
    const bool on = values.value(0).toBool();
    if (!hasScene() || on == parts_.document.scene().constraints[index_].friction.has_value()) return hasScene();
    return setFriction(surface_->switched(on), on ? tr("friction on") : tr("friction off"), true);
  });
  parts_.actions.addCommand("smooth.set", [this](const QVariantList& degrees) {
    return degrees.size() == 1 && setSmoothing(degrees[0].toDouble(), true);
  });
  parts_.actions.addCommand("search.set", [this](const QVariantList& values) {
    for (const auto& word : scene::kSearchWords) {
      if (values.value(0).toString() == word.word) return setSearch(word.value);
    }
    return false;
  });
}

void FeelPanel::addGuideCommands() {
  parts_.actions.addCommand("guide.on", [this](const QVariantList& values) {
    const bool on = values.value(0).toBool();
    if (!hasScene() || on == guideOf(parts_.document.scene().constraints[index_]).has_value()) return hasScene();
    return setGuide(guide_->switched(on), on ? tr("guide on") : tr("guide off"), true);
  });
  parts_.actions.addCommand("guide.set", [this](const QVariantList& numbers) {  // t, mm/s, mm
    if (numbers.size() != 3) return false;
    return setGuide(scene::CurveGuide{numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()}, tr("guide"),
                    true);
  });
}

void FeelPanel::present(const servo::Snapshot&) {
  if (!stale_ || influence_->isHeld() || surface_->isHeld() || guide_->isHeld() || rate_->isHeld()) return;
  for (const auto& axes : rows_) {
    for (const GainRow* row : axes) {
      if (row->isHeld()) return;  // the hand wins; what holds is shown when it lets go
    }
  }
  refresh();
}

bool FeelPanel::setGain(int gain, int axis, double value, bool fresh) {
  if (!hasScene()) return false;
  scene::Control control = scene::controlOf(parts_.document.scene(), index_);
  Vec3& axes = gainOf(control.gains, gain);
  const bool linked = link_->isChecked();
  if (linked)
    axes.setConstant(value);
  else
    axes[axis] = value;
  const QString name = QCoreApplication::translate("gain", gainKind(gain).name).toLower();
  return send(control, linked ? name : QString("%1 %2").arg(name, axisName(control, axis)), fresh);
}

bool FeelPanel::setLaw(scene::LawType law) {
  if (!hasScene()) return false;
  scene::Control control = scene::controlOf(parts_.document.scene(), index_);
  control.law = law;
  return send(control, tr("law"), true);
}

bool FeelPanel::setSpace(tick::Space space) {
  if (!hasScene()) return false;
  scene::Control control = scene::controlOf(parts_.document.scene(), index_);
  control.space = space;
  return send(control, tr("where the control works"), true);
}

bool FeelPanel::setVelocity(const scene::Velocity& velocity, const QString& what, bool fresh) {
  if (!hasScene()) return false;
  scene::Control control = scene::controlOf(parts_.document.scene(), index_);
  control.velocity = velocity;
  return send(control, what, fresh);
}

bool FeelPanel::setPassivity(control::Passivity passivity) {
  if (!hasScene()) return false;
  scene::Control control = scene::controlOf(parts_.document.scene(), index_);
  control.passivity = passivity;
  return send(control, tr("passivity"), true);
}

bool FeelPanel::resetToScene() {
  if (!hasScene()) return false;
  const scene::Description gains = scene::withControl(parts_.document.scene(), index_, parts_.document.own(index_));
  const scene::Description turned = scene::withInfluence(gains, index_, parts_.document.ownInfluence(index_));
  const scene::Description rubbed = scene::withFriction(turned, index_, parts_.document.ownFriction(index_));
  const scene::Description led = scene::withGuide(rubbed, index_, parts_.document.ownGuide(index_));
  const scene::Description edited =
      scene::withSmoothing(led, index_, parts_.document.ownSmoothing(index_).value_or(0.0));
  return sendScene(edited, tr("reset to scene"), true);
}

bool FeelPanel::setInfluence(const std::optional<scene::Influence>& influence, const QString& what, bool fresh) {
  return hasScene() && sendScene(scene::withInfluence(parts_.document.scene(), index_, influence), what, fresh);
}

bool FeelPanel::setFriction(const std::optional<scene::Friction>& friction, const QString& what, bool fresh) {
  return hasScene() && sendScene(scene::withFriction(parts_.document.scene(), index_, friction), what, fresh);
}

bool FeelPanel::setGuide(const std::optional<scene::CurveGuide>& guide, const QString& what, bool fresh) {
  return hasScene() && sendScene(scene::withGuide(parts_.document.scene(), index_, guide), what, fresh);
}

bool FeelPanel::setSmoothing(double smooth_deg, bool fresh) {
  if (!hasScene() || !smoothingOf(parts_.document.scene().constraints[index_])) return false;
  return sendScene(scene::withSmoothing(parts_.document.scene(), index_, smooth_deg), tr("smoothing"), fresh);
}

bool FeelPanel::setSearch(Search search) {
  if (!hasScene()) return false;
  scene::Shape shape = parts_.document.scene().constraints[index_].shape;
  auto* const mesh = std::get_if<scene::Mesh>(&shape);
  auto* const curve = std::get_if<scene::Curve>(&shape);
  if (mesh == nullptr && curve == nullptr) return false;
  (mesh != nullptr ? mesh->search : curve->search) = search;
  return sendScene(scene::withShape(parts_.document.scene(), index_, shape), tr("search"), true);
}

bool FeelPanel::send(const scene::Control& control, const QString& what, bool fresh) {
  return sendScene(scene::withControl(parts_.document.scene(), index_, control), what, fresh);
}

bool FeelPanel::sendScene(const scene::Description& edited, const QString& what, bool fresh) {
  if (fresh) gesture_ = parts_.document.newGesture();
  const Problems problems = parts_.document.edit(edited, what, gesture_);
  stale_ = true;  // refused? the next snapshot puts it back
  refusal_->setText(problems.empty() ? QString() : sentencesOf(problems));
  refusal_->setVisible(!problems.empty());
  return problems.empty();
}

void FeelPanel::sceneOpened() {
  const scene::Description& scene = parts_.document.scene();
  const QSignalBlocker silent(constraint_);
  constraint_->clear();
  for (const scene::Constraint& constraint : scene.constraints) {
    constraint_->addItem(QString::fromStdString(constraint.name));
  }
  constraint_->setCurrentIndex(0);
  index_ = 0;
  beginInfluence();
  choices_->setRowVisible(constraint_, constraint_->count() > 1);
  refusal_->hide();
  if (hasScene()) {
    const scene::Gains& gains = scene::controlOf(scene, index_).gains;
    link_->setChecked(allEqual(gains.kp_N_per_mm) && allEqual(gains.kd_N_s_per_mm) && allEqual(gains.ki_N_per_mm_s));
  }
  refresh();
}

void FeelPanel::sceneEdited() {
  const std::vector<scene::Constraint>& now = parts_.document.scene().constraints;
  bool alike = static_cast<std::size_t>(constraint_->count()) == now.size();
  for (std::size_t index = 0; alike && index < now.size(); ++index) {
    alike = constraint_->itemText(static_cast<int>(index)) == QString::fromStdString(now[index].name);
  }
  if (alike)
    refresh();
  else
    sceneOpened();  // a constraint came or went
}

void FeelPanel::refresh() {
  setEnabled(hasScene());
  parts_.actions.find("gains.reset")->setEnabled(false);
  if (!hasScene()) return;
  stale_ = false;
  const scene::Control& control = scene::controlOf(parts_.document.scene(), index_);
  const scene::Control& own = parts_.document.own(index_);
  scene::Gains shown = control.gains, marked = own.gains;
  bool equal = true;
  for (int gain = 0; gain < kGainKinds; ++gain) {
    for (int axis = 0; axis < 3; ++axis) {
      GainRow* row = rows_[static_cast<std::size_t>(gain)][static_cast<std::size_t>(axis)];
      row->setAxisName(axisName(control, axis));
      row->present(gainOf(shown, gain)[axis], gainOf(marked, gain)[axis]);
    }
    equal = equal && allEqual(gainOf(shown, gain));
  }
  if (!equal) link_->setChecked(false);  // the next change of one axis must not wipe out the others
  const QSignalBlocker silent_law(law_), silent_choice(anisotropy_), silent_space(space_);
  law_->setCurrentIndex(static_cast<int>(control.law));
  anisotropy_->setCurrentIndex(static_cast<int>(control.anisotropy));
  const bool in_joints = control.space == tick::Space::Joint;
  space_->setCurrentIndex(static_cast<int>(control.space));
  choices_->setRowVisible(anisotropy_, !in_joints && !allEqual(shown.kp_N_per_mm));
  link_->setText(in_joints ? tr("L&ink q1, q2 and q3") : tr("L&ink x, y and z"));
  link_->setAccessibleName(link_->text().remove('&'));
  sections_[1]->setVisible(control.law != scene::LawType::P);
  sections_[2]->setVisible(control.law == scene::LawType::PID);
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  const bool same = constraint.influence == parts_.document.ownInfluence(index_) &&
                    constraint.friction == parts_.document.ownFriction(index_) &&
                    guideOf(constraint) == parts_.document.ownGuide(index_) &&
                    smoothingOf(constraint) == parts_.document.ownSmoothing(index_);
  parts_.actions.find("gains.reset")->setEnabled(!(control == own && same));
  refreshInfluence();
  refreshSurface();
  rate_->present(control, own);
  refreshWarnings(control);
}

void FeelPanel::beginInfluence() {
  if (!hasScene()) return;
  const bool has_axis = !std::holds_alternative<scene::Sphere>(parts_.document.scene().constraints[index_].shape);
  influence_->begin(parts_.document.ownInfluence(index_), has_axis);
  surface_->begin(parts_.document.ownFriction(index_));
  guide_->begin(parts_.document.ownGuide(index_));
}

void FeelPanel::refreshInfluence() {
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  influence_->setVisible(scene::takesInfluence(constraint.shape));
  influence_->present(constraint.influence, parts_.document.ownInfluence(index_));
}

void FeelPanel::refreshSurface() {
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  const auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape);
  const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
  std::optional<Search> search;
  if (mesh != nullptr && constraint.side == target::Side::Both) search = mesh->search;
  if (curve != nullptr) search = curve->search;
  guide_->setVisible(curve != nullptr);
  guide_->present(curve != nullptr ? curve->guide : std::nullopt, parts_.document.ownGuide(index_));
  surface_->setVisible(scene::takesFriction(constraint.shape));
  surface_->present({constraint.friction, smoothingOf(constraint), search},
                    {parts_.document.ownFriction(index_), parts_.document.ownSmoothing(index_), {}});
}

void FeelPanel::refreshWarnings(const scene::Control& control) {
  QStringList reasons;
  for (int axis = 0; axis < 3; ++axis) {
    const QString reason = whyItMayBuzz(control, axis, parts_.servo.rateHz());
    rows_[0][static_cast<std::size_t>(axis)]->setWarning(reason);
    if (!reason.isEmpty()) reasons << reason;
  }
  warning_->setText(reasons.isEmpty() ? QString() : reasons.first());  // one reason holds for all of them
  warning_->setVisible(!reasons.isEmpty());
}

}  // namespace underact::gui
