#include "app/gui/feel/feel_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/feature/setting_rows.h"
#include "app/gui/feel/feel_foot.h"
#include "app/gui/feel/feel_sections.h"
#include "app/gui/feel/gain_section.h"
#include "app/gui/feel/optional_section.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/panel_form.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/model/setting_words.h"
#include "app/gui/model/stability.h"
#include "core/scene/edit.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

constexpr const char* kGuideSpeed = "/guide/speed_mm_per_s";

}  // namespace

FeelPanel::FeelPanel(const Parts& parts, QWidget* parent)
    : Panel(parent), parts_(parts), rows_(new SettingRows(this)), gains_(new GainSection(this)) {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  buildChoices(column);
  column->addWidget(gains_);
  buildSections(column);
  column->addStretch(1);
  addActions();
  QScrollArea* scroll = panelScroll(content, this);
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 16);
  auto* outer = tight<QVBoxLayout>(this, 0);
  outer->addWidget(scroll, 1);
  outer->addWidget(foot_ = new FeelFoot(parts_.actions, this));
  connect(rows_, &SettingRows::asked, this, &FeelPanel::set);
  connect(gains_, &GainSection::asked, this, &FeelPanel::setGain);
  connect(&parts_.document, &Document::opened, this, &FeelPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &FeelPanel::sceneEdited);
  connect(&parts_.rate, &ServoRate::changed, this, [this] { stale_ = true; });  // the warnings depend on it
  sceneOpened();
}

void FeelPanel::buildChoices(QVBoxLayout* column) {
  choices_ = panelForm();
  constraint_ = chooser("panel.feel.constraint", tr("Constraint whose gains are shown"),
                        tr("Selects the constraint whose gains are shown below."), this);
  choices_->addRow(tr("&Constraint"), constraint_);
  rows_->addChoice({"/control/law", "panel.feel.law", tr("&Law"), tr("Control law")}, choices_, this);
  rows_->addChoice({"/control/space", "panel.feel.space", tr("&Works on"), tr("What the control law works on")},
                   choices_, this);
  rows_->addChoice(
      {"/control/anisotropy", "panel.feel.anisotropy", tr("&Nearest"), tr("Nearest point with unequal gains")},
      choices_, this);
  column->addLayout(choices_);
  connect(constraint_, &QComboBox::currentIndexChanged, this, &FeelPanel::choose);
}

void FeelPanel::buildSections(QVBoxLayout* column) {
  influence_ = makeInfluence(*rows_, this);
  surface_ = makeSurface(*rows_, this);
  guide_ = makeGuidance(*rows_, backwards_, this);
  for (OptionalSection* const section : {influence_, surface_, guide_}) {
    column->addWidget(section);
    connect(section, &OptionalSection::switchAsked, this,
            [=, this](bool on) { setAll(section->switchedWords(on), section->switched(on), true); });
  }
  column->addWidget(makeRate(*rows_, this));
  connect(backwards_, &QCheckBox::toggled, this, [this] {
    const scene::SettingValue speed = parts_.document.value(index_, kGuideSpeed);
    if (scene::isNone(speed)) return;
    setAll(tr("direction of the guide"), {{kGuideSpeed, -std::get<double>(speed)}}, true);
  });
}

bool FeelPanel::hasScene() const {
  return !parts_.document.scene().constraints.empty();
}

void FeelPanel::addActions() {
  parts_.actions.add(
      {"gains.reset", tr("Reset to &scene"), QKeySequence("Ctrl+R"),
       tr("Restores control law, gains, influence, friction and guidance to the values in the scene file."), "reset"},
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
  addSwitch("influence.on", influence_);
  addSwitch("friction.on", surface_);
  addSwitch("guide.on", guide_);
  parts_.actions.addCommand("friction.set", [this](const QVariantList& shares) {
    return shares.size() == 2 &&
           setAll(tr("friction"),
                  {{"/friction/static", shares[0].toDouble()}, {"/friction/dynamic", shares[1].toDouble()}}, true);
  });
  parts_.actions.addCommand("guide.set", [this](const QVariantList& numbers) {  // t, mm/s, mm
    return numbers.size() == 3 && setAll(tr("guide"),
                                         {{kGuideSpeed, numbers[1].toDouble()},
                                          {"/guide/t", numbers[0].toDouble()},
                                          {"/guide/lead_mm", numbers[2].toDouble()}},
                                         true);
  });
}

/// A command that sets the setting at a path, if it has a value.
void FeelPanel::addCommand(const QString& name, const std::string& path) {
  parts_.actions.addCommand(name, [this, path](const QVariantList& values) {
    if (values.size() != 1 || !hasScene()) return false;
    const scene::SettingValue now = parts_.document.value(index_, path);
    if (scene::isNone(now)) return false;
    const bool is_word = std::holds_alternative<std::string>(now);
    return set(path, is_word ? scene::SettingValue(values[0].toString().toStdString()) : values[0].toDouble(), true);
  });
}

void FeelPanel::addSwitch(const QString& name, OptionalSection* section) {
  parts_.actions.addCommand(name, [=, this](const QVariantList& values) {
    const bool on = values.value(0).toBool();
    if (!hasScene() || on == section->isOn(parts_.document, index_)) return hasScene();
    return setAll(section->switchedWords(on), section->switched(on), true);
  });
}

void FeelPanel::present(const servo::Snapshot&) {
  if (stale_ && !gains_->isHeld() && !rows_->isHeld()) refresh();  // not while a slider is dragged
}

bool FeelPanel::setGain(int gain, int axis, double value, bool fresh) {
  if (!hasScene()) return false;
  const GainSection::Wanted wanted =
      gains_->changed(scene::controlOf(parts_.document.scene(), index_), gain, axis, value);
  return setAll(wanted.what, {{gainKind(gain).path, wanted.axes}}, fresh);
}

bool FeelPanel::set(const std::string& path, const scene::SettingValue& value, bool fresh) {
  return setAll(settingLabel("/constraints/*" + path), withCompany(path, value), fresh);
}

std::vector<SettingChange> FeelPanel::withCompany(const std::string& path, const scene::SettingValue& value) const {
  const double* const number = std::get_if<double>(&value);
  const scene::SettingValue fixed = parts_.document.value(index_, "/friction/static"),
                            slides = parts_.document.value(index_, "/friction/dynamic");
  // Dynamic friction never exceeds static friction: setting one adjusts the other.
  if (path == "/friction/static" && number != nullptr && !scene::isNone(slides))
    return {{path, value}, {"/friction/dynamic", std::min(*number, std::get<double>(slides))}};
  if (path == "/friction/dynamic" && number != nullptr && !scene::isNone(fixed))
    return {{"/friction/static", std::max(*number, std::get<double>(fixed))}, {path, value}};
  if (path == kGuideSpeed && number != nullptr && backwards_->isChecked()) return {{path, -*number}};
  return {{path, value}};
}

bool FeelPanel::setAll(const QString& what, const std::vector<SettingChange>& changes, bool fresh) {
  if (!hasScene()) return false;
  const std::string control = "/control", constraint = "/constraints/" + std::to_string(index_);
  scene::Description edited = parts_.document.scene();
  const std::string its_control = scene::controlPath(edited, index_);
  for (const SettingChange& change : changes) {
    const bool is_of_control = change.path.starts_with(control);
    Result<scene::Description> next = scene::withValue(
        edited, is_of_control ? its_control + change.path.substr(control.size()) : constraint + change.path,
        change.value);
    if (!next) return refuse(next.problems());
    edited = std::move(next).value();
  }
  return sendScene(edited, what, fresh);
}

/// The scene, with the settings of this panel as they are in the file.
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
    const Result<scene::SettingValue> default_value = scene::defaultAt(edited, here + path);
    if (scene::isNone(own) && object == any && default_value)
      own = default_value.value();  // a constraint that is not in the file
    const Result<scene::Description> next = scene::withValue(edited, here + path, own);
    if (next) edited = next.value();  // otherwise neither has the setting
  }
  return edited;
}

bool FeelPanel::resetToScene() {
  return hasScene() && sendScene(asWritten(), tr("reset to scene"), true);
}

bool FeelPanel::sendScene(const scene::Description& edited, const QString& what, bool fresh) {
  if (fresh) gesture_ = parts_.document.newGesture();
  return refuse(parts_.document.edit(edited, what, gesture_));
}

bool FeelPanel::refuse(const Problems& problems) {
  stale_ = true;  // if refused, the next snapshot restores what is shown
  foot_->refuse(sentencesOf(problems));
  return problems.empty();
}

void FeelPanel::choose(int row) {
  if (row < 0) return;
  index_ = static_cast<std::size_t>(row);
  gesture_ = parts_.document.newGesture();  // changes of another constraint are a separate undo step
  begin();
  refresh();
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
  begin();
  choices_->setRowVisible(constraint_, constraint_->count() > 1);
  foot_->refuse({});
  if (hasScene()) gains_->begin(scene::controlOf(scene, index_));
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
    sceneOpened();  // a constraint was added or removed
}

void FeelPanel::begin() {
  if (!hasScene()) return;
  for (OptionalSection* const section : {influence_, surface_, guide_}) section->begin(parts_.document, index_);
}

/// Whether the setting has no effect here, even if the file has it.
bool FeelPanel::isIdle(const std::string& path) const {
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  const scene::Control& control = scene::controlOf(parts_.document.scene(), index_);
  const Vec3& kp = control.gains.kp_N_per_mm;
  if (path == "/control/anisotropy") return control.space == tick::Space::Joint || (kp.array() == kp.x()).all();
  if (path.starts_with("/control/velocity/")) return control.law == scene::LawType::P;
  if (path == "/search") return constraint.side != target::Side::Both;  // the proxy of a wall needs no search
  if (path == "/influence/blend_deg") return std::holds_alternative<scene::Sphere>(constraint.shape);  // no axis
  return false;
}

void FeelPanel::refresh() {
  setEnabled(hasScene());
  parts_.actions.find("gains.reset")->setEnabled(false);
  if (!hasScene()) return;
  stale_ = false;
  const scene::Constraint& constraint = parts_.document.scene().constraints[index_];
  const scene::Control& control = scene::controlOf(parts_.document.scene(), index_);
  gains_->present(control, parts_.document.own(index_));
  parts_.actions.find("gains.reset")->setEnabled(!scene::isSame(asWritten(), parts_.document.scene()));
  influence_->setVisible(scene::takesInfluence(constraint.shape));
  surface_->setVisible(scene::takesFriction(constraint.shape));
  guide_->setVisible(std::holds_alternative<scene::Curve>(constraint.shape));
  for (OptionalSection* const section : {influence_, surface_, guide_}) section->present(parts_.document, index_);
  rows_->present(parts_.document, index_, [this](const std::string& path) { return isIdle(path); });
  // A speed of 0 has no sign: the direction stays as it was chosen last.
  const scene::SettingValue speed = parts_.document.value(index_, kGuideSpeed);
  const QSignalBlocker silent(backwards_);  // showing a value must not set it
  if (const double* one = std::get_if<double>(&speed); one && *one != 0.0) backwards_->setChecked(*one < 0.0);
  refreshWarnings(control);
}

void FeelPanel::refreshWarnings(const scene::Control& control) {
  QStringList reasons;
  for (int axis = 0; axis < 3; ++axis) {
    const QString reason = buzzWarning(control, axis, parts_.servo.rateHz());
    gains_->setWarning(axis, reason);
    if (!reason.isEmpty()) reasons << reason;
  }
  foot_->warn(reasons.isEmpty() ? QString() : reasons.first());  // the same for all axes
}

}  // namespace underact::gui
