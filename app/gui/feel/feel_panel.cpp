#include "app/gui/feel/feel_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "app/gui/feature/gain_row.h"
#include "app/gui/feel/guide_section.h"
#include "app/gui/feel/influence_section.h"
#include "app/gui/feel/rate_section.h"
#include "app/gui/feel/surface_section.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/model/stability.h"
#include "core/scene/edit.h"
#include "core/scene/fields.h"
#include "core/scene/settings.h"

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
  addCommand("law.set", "/control/law");
  addCommand("space.set", "/control/space");
  addCommand("passivity.set", "/control/passivity");
  addCommand("influence.set", "/influence/t");
  addCommand("smooth.set", "/smooth_deg");
  addCommand("search.set", "/search");
  parts_.actions.addCommand("friction.set", [this](const QVariantList& shares) {
    if (shares.size() != 2) return false;
    return setFriction(scene::Friction{shares[0].toDouble(), shares[1].toDouble()}, tr("friction"), true);
  });
  parts_.actions.addCommand("guide.set", [this](const QVariantList& numbers) {  // t, mm/s, mm
    if (numbers.size() != 3) return false;
    return setGuide(scene::CurveGuide{numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()}, tr("guide"),
                    true);
  });
}

/// Sets what has a value there.
void FeelPanel::addCommand(const QString& name, const std::string& path) {
  parts_.actions.addCommand(name, [this, path](const QVariantList& values) {
    if (values.size() != 1 || !hasScene()) return false;
    const scene::Description& scene = parts_.document.scene();
    const Result<scene::SettingValue> now = scene::valueAt(scene, "/constraints/" + std::to_string(index_) + path);
    if (!now || scene::isNone(now.value())) return false;
    const bool is_word = std::holds_alternative<std::string>(now.value());
    return set(path, is_word ? scene::SettingValue(values[0].toString().toStdString()) : values[0].toDouble(), true);
  });
}

void FeelPanel::addSwitches() {
  const auto add = [this](const char* name, const auto& is_on, const auto& turn) {
    parts_.actions.addCommand(name, [=, this](const QVariantList& values) {
      const bool on = values.value(0).toBool();
      if (!hasScene() || on == is_on(parts_.document.scene().constraints[index_])) return hasScene();
      return turn(on);
    });
  };
  add(
      "influence.on", [](const scene::Constraint& one) { return one.influence.has_value(); },
      [this](bool on) {
        return setInfluence(influence_->switched(on), on ? tr("influence on") : tr("influence off"), true);
      });
  add(
      "friction.on", [](const scene::Constraint& one) { return one.friction.has_value(); },
      [this](bool on) {
        return setFriction(surface_->switched(on), on ? tr("friction on") : tr("friction off"), true);
      });
  add(
      "guide.on", [](const scene::Constraint& one) { return guideOf(one).has_value(); },
      [this](bool on) { return setGuide(guide_->switched(on), on ? tr("guide on") : tr("guide off"), true); });
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
  const scene::Control& control = scene::controlOf(parts_.document.scene(), index_);
  scene::Gains gains = control.gains;
  Vec3& axes = gainOf(gains, gain);
  const bool linked = link_->isChecked();
  if (linked)
    axes.setConstant(value);
  else
    axes[axis] = value;
  const char* const path = gainKind(gain).path;
  const QString what = linked ? settingLabel(path) : QString("%1 %2").arg(settingLabel(path), axisName(control, axis));
  return setAs(what, path, axes, fresh);
}

bool FeelPanel::set(const std::string& path, const scene::SettingValue& value, bool fresh) {
  return setAs(settingLabel("/constraints/*" + path), path, value, fresh);
}

bool FeelPanel::setAs(const QString& what, const std::string& path, const scene::SettingValue& value, bool fresh) {
  if (!hasScene()) return false;
  const scene::Description& scene = parts_.document.scene();
  const std::string control = "/control";
  const std::string whole = path.starts_with(control) ? scene::controlPath(scene, index_) + path.substr(control.size())
                                                      : "/constraints/" + std::to_string(index_) + path;
  const Result<scene::Description> edited = scene::withValue(scene, whole, value);
  return edited ? sendScene(edited.value(), what, fresh) : refuse(edited.problems());
}

/// The scene with what this panel shows as the file has it.
scene::Description FeelPanel::asWritten() const {
  scene::Description edited = scene::withControl(parts_.document.scene(), index_, parts_.document.own(index_));
  const std::string any = "/constraints/*", here = "/constraints/" + std::to_string(index_);
  for (const scene::Setting& setting : scene::settings()) {
    const std::string_view object = setting.object;
    const bool is_here = object == any + "/influence" || object == any + "/friction" || object == any + "/guide" ||
                         setting.key == std::string_view("smooth_deg");
    if (!is_here) continue;
    const std::string path = pathOf(setting).substr(any.size());
    scene::SettingValue own = parts_.document.own(index_, path);
    const Result<scene::SettingValue> usual = scene::usualAt(edited, here + path);
    if (scene::isNone(own) && object == any && usual) own = usual.value();  // of a constraint that the file has not
    const Result<scene::Description> next = scene::withValue(edited, here + path, own);
    if (next) edited = next.value();  // else there is no such thing, here and there
  }
  return edited;
}

bool FeelPanel::resetToScene() {
  return hasScene() && sendScene(asWritten(), tr("reset to scene"), true);
}

bool FeelPanel::setInfluence(const std::optional<scene::Influence>& influence, const QString& what, bool fresh) {
  if (!hasScene()) return false;
  scene::Description edited = parts_.document.scene();
  edited.constraints[index_].influence = influence;
  return sendScene(edited, what, fresh);
}

bool FeelPanel::setFriction(const std::optional<scene::Friction>& friction, const QString& what, bool fresh) {
  if (!hasScene()) return false;
  scene::Description edited = parts_.document.scene();
  edited.constraints[index_].friction = friction;
  return sendScene(edited, what, fresh);
}

bool FeelPanel::setGuide(const std::optional<scene::CurveGuide>& guide, const QString& what, bool fresh) {
  if (!hasScene()) return false;
  scene::Description edited = parts_.document.scene();
  if (auto* const curve = std::get_if<scene::Curve>(&edited.constraints[index_].shape)) curve->guide = guide;
  return sendScene(edited, what, fresh);
}

bool FeelPanel::sendScene(const scene::Description& edited, const QString& what, bool fresh) {
  if (fresh) gesture_ = parts_.document.newGesture();
  return refuse(parts_.document.edit(edited, what, gesture_));
}

bool FeelPanel::refuse(const Problems& problems) {
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
  parts_.actions.find("gains.reset")->setEnabled(!scene::isSame(asWritten(), parts_.document.scene()));
  refreshInfluence();
  refreshSurface();
  rate_->present(control, own);
  refreshWarnings(control);
}

void FeelPanel::beginInfluence() {
  if (!hasScene()) return;
  const bool has_axis = !std::holds_alternative<scene::Sphere>(parts_.document.scene().constraints[index_].shape);
  const scene::Constraint& own = parts_.document.written(index_);
  influence_->begin(own.influence, has_axis);
  surface_->begin(own.friction);
  guide_->begin(guideOf(own));
}

void FeelPanel::refreshInfluence() {
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  influence_->setVisible(scene::takesInfluence(constraint.shape));
  influence_->present(constraint.influence, parts_.document.written(index_).influence);
}

void FeelPanel::refreshSurface() {
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  const auto* const mesh = std::get_if<scene::Mesh>(&constraint.shape);
  const auto* const curve = std::get_if<scene::Curve>(&constraint.shape);
  std::optional<Search> search;
  if (mesh != nullptr && constraint.side == target::Side::Both) search = mesh->search;
  if (curve != nullptr) search = curve->search;
  guide_->setVisible(curve != nullptr);
  const scene::Constraint& own = parts_.document.written(index_);
  guide_->present(guideOf(constraint), guideOf(own));
  surface_->setVisible(scene::takesFriction(constraint.shape));
  surface_->present({constraint.friction, smoothingOf(constraint), search}, {own.friction, smoothingOf(own), {}});
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
