#include "app/gui/model/document.h"

#include <QFileInfo>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/gui/kit/edit.h"
#include "core/scene/edit.h"
#include "core/scene/mesh_names.h"
#include "core/scene/mirror.h"
#include "core/scene/write.h"

namespace underact::gui {
namespace {

constexpr std::chrono::milliseconds kTellsAfter{40};

scene::SettingValue valueIn(const scene::Description& scene, std::size_t index, const std::string& path) {
  const Result<scene::SettingValue> value = scene::valueAt(scene, "/constraints/" + std::to_string(index) + path);
  return value ? value.value() : scene::SettingValue();
}

}  // namespace

Document::Document(servo::Host& host, QObject* parent) : QObject(parent), host_(host), undo_(this) {
  tells_.setSingleShot(true);
  tells_.setInterval(kTellsAfter);
  connect(&tells_, &QTimer::timeout, this, &Document::edited);
  connect(&undo_, &QUndoStack::cleanChanged, this, [this] { emit modifiedChanged(modified()); });
}

Problems Document::open(scene::Description opened, const std::optional<scene::Description>& tuned) {
  const bool mirrors = opensMirrored();
  const scene::Description& wanted = tuned ? *tuned : opened;
  Problems problems = host_.load(mirrors ? scene::mirrored(wanted) : wanted);
  if (!problems.empty()) return problems;
  kept_.reset();
  is_mirrored_ = mirrors;
  original_ = mirrors ? scene::mirrored(opened) : opened;
  path_ = QString::fromStdString(original_.file);
  is_open_ = true;
  undo_.clear();
  if (tuned) pushEdit(std::move(opened), *tuned, tr("tuning of last time"), newGesture());
  if (path_.isEmpty()) undo_.resetClean();  // a scene that was never saved counts as unsaved
  emit this->opened();
  return {};
}

Problems Document::saveAs(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  const std::optional<scene::Teaching> teaching = scene::teachingOf(path_.toStdString());  // kept from the old file
  Problems problems =
      scene::writeSceneFile(scene::namedFrom(asWritten(), file.toStdString()), file.toStdString(), teaching);
  if (!problems.empty()) return problems;
  path_ = file;
  original_ = scene();
  undo_.setClean();
  emit edited();  // the marks of the scene's own values change
  return {};
}

Problems Document::edit(const scene::Description& after, const QString& what, int gesture) {
  if (scene::isSame(scene(), after)) return {};
  Problems problems = change(after, what, gesture, 0);
  if (!problems.empty()) return problems;
  emit edited();
  emit editedHere();
  return {};
}

Problems Document::steer(const scene::Description& after, const QString& what, int gesture, std::int64_t over_ticks) {
  if (scene::isSame(scene(), after)) return {};
  Problems problems = change(after, what, gesture, over_ticks);
  if (problems.empty() && !tells_.isActive()) tells_.start();
  return problems;
}

Problems Document::change(const scene::Description& after, const QString& what, int gesture, std::int64_t over_ticks) {
  const scene::Description before = scene();
  // What is written stays as it is when the scene gets another arm, which may be mirrored elsewhere.
  const arm::MirrorPlane plane = scene::mirrorPlaneOf(before);
  const scene::Description written = is_mirrored_ ? scene::mirrored(after, plane) : after;
  const bool moves = is_mirrored_ && !(plane == scene::mirrorPlaneOf(after));
  Problems problems = host_.edit(moves ? throughMirror(written) : after, over_ticks);
  if (!problems.empty()) return problems;
  kept_.reset();
  pushEdit(throughMirror(before), written, what, gesture);
  return {};
}

void Document::pushEdit(scene::Description before, scene::Description after, const QString& what, int gesture) {
  undo_.push(new Edit<scene::Description>(
      std::move(before), std::move(after), [this](const scene::Description& written) { put(written); }, what, gesture));
}

void Document::put(const scene::Description& written) {
  // It was in effect before, so it cannot be refused; in any case the panels show what is in effect.
  static_cast<void>(host_.edit(throughMirror(written)));
  kept_.reset();
  emit edited();
}

Problems Document::tryOut(const scene::Description& tried) {
  scene::Description own = scene();
  Problems problems = host_.edit(tried);
  if (problems.empty()) kept_ = std::move(own);
  return problems;
}

void Document::putBack() {
  if (!kept_) return;
  static_cast<void>(host_.edit(*kept_));  // it was in effect before, so it cannot be refused
  kept_.reset();
}

Problems Document::showRecorded(const scene::Description& shown) {
  const scene::Change change = scene::changeBetween(scene(), shown);
  Own own{asWritten(), throughMirror(original_), path_};
  Problems problems = host_.edit(shown);
  if (!problems.empty()) return problems;
  if (!own_) own_ = std::move(own);
  const bool is_another = change == scene::Change::Scene || !path_.isEmpty();
  kept_.reset();
  is_mirrored_ = false;  // a recording is shown as it was made
  original_ = shown;
  path_.clear();
  undo_.clear();
  is_another ? emit opened() : emit edited();
  return {};
}

void Document::putBackOwn() {
  if (!own_) return;
  const Own own = std::move(*own_);
  own_.reset();
  kept_.reset();
  undo_.clear();
  if (own.scene.constraints.empty()) return;  // no scene was open: the recording's last one stays
  is_mirrored_ = opensMirrored();
  static_cast<void>(host_.load(throughMirror(own.scene)));  // it was in effect before
  original_ = throughMirror(own.original);
  path_ = own.path;
  if (!scene::isSame(own.original, own.scene)) pushEdit(own.original, own.scene, tr("edits"), newGesture());
  if (path_.isEmpty()) undo_.resetClean();
  emit opened();
}

const scene::Constraint& Document::written(std::size_t index) const {
  static const scene::Constraint kNone{};
  const std::vector<scene::Constraint>& now = scene().constraints;
  if (index >= now.size()) return kNone;
  const auto found = std::find_if(original_.constraints.begin(), original_.constraints.end(),
                                  [&](const scene::Constraint& one) { return one.name == now[index].name; });
  return found == original_.constraints.end() ? kNone : *found;
}

const scene::Control& Document::own(std::size_t index) const {
  const scene::Constraint& one = written(index);
  return one.control ? *one.control : original_.control;
}

scene::SettingValue Document::own(std::size_t index, const std::string& path) const {
  scene::Description alone;
  alone.control = original_.control;
  alone.constraints.push_back(written(index));
  return valueIn(alone, 0, path);
}

scene::SettingValue Document::value(std::size_t index, const std::string& path) const {
  return valueIn(scene(), index, path);
}

}  // namespace underact::gui
