#include "app/gui/input_devices/input_devices.h"

#include <QSettings>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/edit.h"
#include "app/gui/kit/words.h"
#include "app/gui/view/hand.h"
#include "core/arm/forward.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"
#include "device/simulated_arm.h"

namespace underact::gui {

namespace input = device::input;

namespace {

constexpr int kPoll_ms = 8, kPollNew_ms = 500;  // the report interval of a 3D mouse; without any device
constexpr int kSave_ms = 300, kGiveUp_ms = 15'000;
constexpr const char* kUnused = "hands/unused";

bool isSameSeen(const input::DeviceState& one, const input::DeviceState& other) {
  const auto isSame = [](const device::Missing& a, const device::Missing& b) { return a.sentence == b.sentence; };
  return one.id == other.id && one.name == other.name &&
         std::equal(one.missing.begin(), one.missing.end(), other.missing.begin(), other.missing.end(), isSame);
}

}  // namespace

InputDevices::InputDevices(ServoFacts servo, Hand& hand, std::vector<input::DeviceEnumerator*> ports, Actions& actions,
                           QWidget* window)
    : QObject(window), servo_(servo), hand_(hand), ports_(std::move(ports)), actions_(actions), window_(window) {
  for (const QString& id : QSettings().value(kUnused).toStringList()) unused_.insert(id);
  poll_timer_.setTimerType(Qt::PreciseTimer);
  connect(&poll_timer_, &QTimer::timeout, this, &InputDevices::poll);
  if (!ports_.empty()) poll_timer_.start(kPollNew_ms);
  saves_.setSingleShot(true);
  connect(&saves_, &QTimer::timeout, this, &InputDevices::save);
  gives_up_.setSingleShot(true);
  connect(&gives_up_, &QTimer::timeout, this, &InputDevices::endLearning);
}

InputDevices::~InputDevices() {
  save();
}

const InputDeviceEntry* InputDevices::find(const QString& id) const {
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const InputDeviceEntry& one) { return one.id() == id; });
  return entry == entries_.end() ? nullptr : &*entry;
}

QString InputDevices::restReason() const {
  if (hand_.arm() == nullptr)
    return tr("The input devices have no effect now: they move the simulated arm, which is not in use.");
  return {};
}

QString InputDevices::trouble() const {
  QStringList lines;
  for (const input::DeviceEnumerator* port : ports_) {
    if (!port->trouble().empty()) lines << sentenceText(port->trouble());
  }
  for (const auto& [id, problem] : problems_) lines << problem;
  return lines.join('\n');
}

void InputDevices::poll() {
  const bool is_new = takeSeen();
  const servo::Snapshot snapshot = servo_.snapshot();
  const std::int64_t time_ns = snapshot.report.sample.time_ns;
  const double dt_s = time_ns_ < 0 ? 0.0 : kSecondPerNanosecond * static_cast<double>(time_ns - time_ns_);
  time_ns_ = time_ns;
  const bool is_free = hand_.arm() != nullptr && window_->isActiveWindow() && !learning_;
  input::Motion all;
  bool stops = false;
  for (InputDeviceEntry& entry : entries_) {
    entry.awake = is_free ? input::updatedReadyAxes(entry.awake, entry.map, entry.seen.readings) : input::ReadyAxes{};
    const input::Motion motion = input::motionOf(entry.map, entry.seen.readings, entry.awake);
    stops = stops || motion.stop;
    entry.moves = is_free && entry.used && !motion.isAtRest();
    if (is_free && entry.used) all = input::combined(all, motion);
  }
  // Only when pressed: Start while the button is held would otherwise be undone at once.
  if (stops && !std::exchange(stops_, stops)) actions_.perform("session.stop");
  stops_ = stops;
  hand_.press(is_free ? all.stylus_buttons : 0U);
  move(is_free ? all : input::Motion{}, dt_s);
  if (learning_) goOnLearning();
  if (is_new) emit changed();
}

void InputDevices::move(const input::Motion& motion, double dt_s) {
  const servo::Snapshot snapshot = servo_.snapshot();
  const bool moves = !motion.isAtRest() && snapshot.ticks > 0;
  if (moves) {
    const Pose X_WT = arm::tipPose(scene::armOf(servo_.scene()).geometry, snapshot.report.sample.q_rad);
    hand_.moveTo(input::movedSetpoint(hand_.setpoint(), motion, dt_s, X_WT));
  } else if (moved_) {
    hand_.rest();
  }
  moved_ = moves;
}

/// Reads the devices. Whether anything other than their readings changed.
bool InputDevices::takeSeen() {
  std::vector<InputDeviceEntry> now;
  bool is_new = false;
  for (input::DeviceEnumerator* port : ports_) {
    const std::string before = port->trouble();
    for (input::DeviceState& seen : port->poll()) take(std::move(seen), now, is_new);
    is_new = is_new || port->trouble() != before;
  }
  is_new = is_new || now.size() != entries_.size();
  entries_ = std::move(now);
  if (!ports_.empty()) poll_timer_.setInterval(entries_.empty() ? kPollNew_ms : kPoll_ms);
  return is_new;
}

void InputDevices::take(input::DeviceState seen, std::vector<InputDeviceEntry>& now, bool& is_new) {
  const QString id = QString::fromStdString(seen.id);
  const auto known =
      std::find_if(entries_.begin(), entries_.end(), [&](const InputDeviceEntry& one) { return one.id() == id; });
  InputDeviceEntry entry;
  if (known != entries_.end()) {
    is_new = is_new || !isSameSeen(known->seen, seen);
    entry = *known;
    entry.seen = std::move(seen);
  } else {
    is_new = true;
    entry.seen = std::move(seen);
    readMap(entry);
  }
  now.push_back(std::move(entry));
}

void InputDevices::readMap(InputDeviceEntry& entry) {
  const QString id = entry.id();
  entry.used = unused_.count(id) == 0;
  defaults_[id] = entry.seen.default_value;
  if (const auto known = maps_.find(id); known != maps_.end()) {
    entry.map = known->second.map;
    return;
  }
  entry.map = entry.seen.default_value;
  const Result<std::optional<input::Map>> kept = store_.load(entry.seen.id);
  if (!kept) {
    const Problem& problem = kept.problems()[0];
    const QString where = QString::fromStdString(describe({{}, problem.place}));
    problems_[id] = tr("The mapping of %1 cannot be read; the default mapping is used. %2")
                        .arg(sentenceText(entry.seen.name), where + sentenceText(problem.sentence));
  } else if (kept.value()) {
    entry.map = *kept.value();
  }
  maps_[id] = {entry.seen.name, entry.seen.id, entry.map};
}

void InputDevices::use(const QString& id, bool on) {
  if (on)
    unused_.erase(id);
  else
    unused_.insert(id);
  for (InputDeviceEntry& entry : entries_) {
    if (entry.id() != id) continue;
    entry.used = on;
    entry.awake = {};
  }
  QSettings().setValue(kUnused, QStringList(unused_.begin(), unused_.end()));
  emit changed();
}

bool InputDevices::change(const QString& id, const input::Map& map, const QString& field, bool fresh) {
  const InputDeviceEntry* const entry = find(id);
  if (entry == nullptr) return false;
  if (entry->map == map) return true;
  if (fresh || id + field != gestured_) ++gesture_;
  gestured_ = id + field;
  const input::Map before = entry->map;
  setMap(id, map);
  undo_.push(new Edit<input::Map>(
      before, map, [this, id](const input::Map& put) { setMap(id, put); }, {}, gesture_));
  return true;
}

bool InputDevices::reset(const QString& id) {
  return defaults_.count(id) > 0 && change(id, defaults_[id], "reset");
}

void InputDevices::setMap(const QString& id, const input::Map& map) {
  maps_[id].map = map;
  problems_.erase(id);
  for (InputDeviceEntry& entry : entries_) {
    if (entry.id() != id) continue;
    entry.map = map;
    entry.awake = {};
  }
  unsaved_.insert(id);
  saves_.start(kSave_ms);
  emit changed();
}

bool InputDevices::learn(const QString& id, const QString& field) {
  const InputDeviceEntry* const entry = find(id);
  const std::optional<Learning> begun = entry == nullptr ? std::nullopt : Learning::of(id, field, entry->seen.readings);
  if (!begun) return false;
  learning_ = begun;
  gives_up_.start(kGiveUp_ms);
  emit changed();
  return true;
}

void InputDevices::endLearning() {
  if (!std::exchange(learning_, {})) return;
  gives_up_.stop();
  emit changed();
}

void InputDevices::goOnLearning() {
  const InputDeviceEntry* const entry = find(learning_->id());
  if (entry == nullptr) return endLearning();
  const std::optional<Learning::Step> step = learning_->take(entry->map, entry->seen.readings);
  if (!step) return;
  const QString id = learning_->id(), field = learning_->field();
  if (step->map) change(id, *step->map, field, step->fresh);
  if (step->is_last) return endLearning();
  emit changed();
}

void InputDevices::save() {
  for (const QString& id : std::exchange(unsaved_, {})) {
    const input::MapFile& file = maps_[id];
    if (file.map == defaults_[id]) {
      store_.forget(file.id);
      continue;
    }
    const Problems problems = store_.save(file);
    if (problems.empty()) continue;
    problems_[id] = sentencesOf(problems);
    emit changed();
  }
}

}  // namespace underact::gui
