#include "app/gui/model/player.h"

#include <QFileInfo>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

#include "app/gui/model/document.h"
#include "core/base/units.h"

namespace underact::gui {

Player::Player(servo::Host& host, Document& document, device::ReplayedArm* arm, PrepareScene prepare, QObject* parent)
    : QObject(parent), host_(host), document_(document), arm_(arm), prepare_(std::move(prepare)) {
  connect(&document, &Document::edited, this, &Player::windowEdited);
  connect(&document, &Document::opened, this, &Player::windowEdited);
}

Player::~Player() = default;

bool Player::open(const QString& path) {
  if (arm_ == nullptr) return false;
  path_ = QFileInfo(path).absoluteFilePath();
  load_ = std::make_unique<Background<Result<LoadedSession>>>(
      [from = path_.toStdString(), prepare = prepare_](WorkState& state) { return loadSession(from, prepare, state); });
  emit loading();
  return true;
}

void Player::cancelLoading() {
  if (load_) load_->cancel();
}

void Player::poll() {
  if (load_) {
    if (std::optional<Result<LoadedSession>> result = load_->take()) {
      const bool is_cancelled = load_->isCancelled();
      load_.reset();
      if (is_cancelled) {
        emit cancelled();
      } else if (*result) {
        begin(std::move(*result).value());
      } else {
        emit failed(path_, result->problems());
      }
    }
  }
  if (isOpen() && !what_if_) followScene();
}

void Player::begin(LoadedSession session) {
  if (!isOpen()) {
    was_running_ = host_.running();
    is_held_ = !host_.device().simulated;
  }
  arm_->replay(session.recorded);  // before the scene, which needs to know how long the arm may stand still
  session_ = std::move(session);
  scene_ = nullptr;
  tried_.reset();
  what_if_ = loops_ = false;
  loop_in_ = 0;
  loop_out_ = lastRow();
  next_.reset();
  comparison_.clear();
  followScene();
  host_.start();
  emit opened();
  emit whatIfChanged(what_if_);
  emit changed();
}

void Player::close() {
  cancelLoading();
  if (!isOpen()) return;
  if (!was_running_ || is_held_) host_.stop();  // a real arm pushes only on request
  arm_->replay(nullptr);
  session_ = {};
  scene_ = nullptr;
  tried_.reset();
  beside_ = {};
  {
    const QScopedValueRollback putting(is_putting_, true);
    document_.putBackOwn();
  }
  emit closed();
}

void Player::followScene() {
  const device::RecordedScene* now = session_.recorded->sceneAt(row());
  if (now == nullptr || now == scene_) return;
  scene_ = now;
  const QScopedValueRollback putting(is_putting_, true);
  const Problems problems = document_.showRecorded(now->scene);
  if (!problems.empty()) emit failed(QString::fromStdString(session_.recorded->path), problems);
}

/// A change of the scene switches what-if on.
void Player::windowEdited() {
  if (!isOpen() || is_putting_) return;
  comparison_.clear();
  setWhatIf(true);
}

void Player::setWhatIf(bool on) {
  if (!isOpen() || on == what_if_) return;
  what_if_ = on;
  comparison_.clear();
  const QScopedValueRollback putting(is_putting_, true);
  if (on && tried_ && scene_ != nullptr) {
    static_cast<void>(document_.edit(*tried_, tr("what if"), document_.newGesture()));  // it was in effect before
  } else if (!on) {
    tried_ = document_.scene();
    scene_ = nullptr;
    followScene();
  }
  emit whatIfChanged(on);
}

void Player::play() {
  if (!isOpen()) return;
  if (host_.snapshot().mode == servo::Mode::Faulted) host_.start();
  if (row() >= lastRow()) comparison_.clear();
  arm_->play();
  emit changed();
}

void Player::pause() {
  if (!isOpen()) return;
  arm_->pause();
  emit changed();
}

void Player::seek(std::int64_t row) {
  if (!isOpen()) return;
  const std::int64_t held = std::clamp<std::int64_t>(row, 0, lastRow());
  if (held == this->row()) return;
  if (host_.snapshot().mode == servo::Mode::Faulted) host_.start();
  if (held != this->row() + 1) comparison_.clear();
  arm_->seek(held);
  emit changed();
}

void Player::setSpeed(double speed) {
  if (arm_ == nullptr) return;
  arm_->setSpeed(speed);
  emit changed();
}

void Player::setLoop(bool on) {
  loops_ = on;
  sendToLoop();
}

void Player::setLoopIn(std::int64_t row) {
  if (!isOpen()) return;
  loop_in_ = std::clamp<std::int64_t>(row, 0, lastRow());
  if (loop_out_ <= loop_in_) loop_out_ = lastRow();
  sendToLoop();
}

void Player::setLoopOut(std::int64_t row) {
  if (!isOpen()) return;
  loop_out_ = std::clamp<std::int64_t>(row, 0, lastRow());
  if (loop_in_ >= loop_out_) loop_in_ = 0;
  sendToLoop();
}

void Player::sendToLoop() {
  if (!isOpen()) return;
  arm_->setLoop(loops_ ? std::optional(std::pair(loop_in_, loop_out_)) : std::nullopt);
  emit changed();
}

void Player::add(const servo::TickRecord& record) {
  beside_ = {};
  if (arm_ == nullptr) return;
  device::ReplayedArm::SampleOrigin place;
  while (!next_ || next_->time_ns < record.time_ns) {
    if (!arm_->take(place)) return;
    next_ = place;
  }
  if (!isOpen() || next_->time_ns != record.time_ns) return;
  const auto row = static_cast<std::size_t>(next_->row);
  if (row >= session_.recorded->rows.size()) return;
  const device::RecordedRow& recorded = session_.recorded->rows[row];
  beside_ = {static_cast<float>(kMillimetrePerMetre) * recorded.error_m, recorded.force_N};
  if (next_->moves) comparison_.add(recorded, record);
}

}  // namespace underact::gui
