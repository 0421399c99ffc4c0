#include "app/gui/ghost/ghost_hand.h"

#include <QFileInfo>
#include <memory>
#include <utility>

#include "app/gui/files/load_strip.h"
#include "app/gui/ghost/ghost_drawing.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "app/gui/view/scene_view.h"
#include "core/scene/mirror.h"

namespace underact::gui {

constexpr double kLooksTheSame_m = 5e-5;  // less than a tenth of a pixel

GhostHand::GhostHand(Document& document, Player& player, LoadStrip& loads, SceneView& view, QObject* parent)
    : QObject(parent), document_(document), player_(player), loads_(loads), view_(view) {
  connect(&loads, &LoadStrip::cancelled, this, [this] { reading_.clear(); });
  connect(&player, &Player::opened, this, &GhostHand::close);  // during a replay nobody can follow
  connect(&document, &Document::leftHandedChanged, this, &GhostHand::setMirrored);
}

bool GhostHand::open(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  if (player_.isOpen() || player_.isLoading()) {
    emit failed(file, {{tr("A session is being replayed. Close the replay first.").toStdString(), {}}});
    return false;
  }
  const auto read = std::make_shared<Result<LoadedGhost>>(Problems{});
  loads_.begin(
      tr("Reading %1").arg(QFileInfo(file).fileName()),
      [read, file](const TaskMonitor& monitor) { *read = loadGhost(file.toStdString(), monitor); },
      [this, read, file] {
        reading_.clear();
        *read ? begin(std::move(*read).value()) : emit failed(file, read->problems());
      });
  reading_ = file;
  return true;
}

void GhostHand::begin(LoadedGhost ghost) {
  ghost_ = std::move(ghost);
  state_ = {};
  options_ = {};
  is_drawn_ = is_mirrored_ = false;
  setMirrored(document_.isLeftHanded());
  emit opened();
  emit changed();
}

void GhostHand::close() {
  if (!reading_.isEmpty()) loads_.cancel();
  if (!isOpen()) return;
  ghost_.reset();
  view_.draw("ghost", {});
  emit closed();
}

void GhostHand::setOptions(const ghost::Options& options) {
  if (!isOpen()) return;
  options_ = options;
  emit changed();
}

void GhostHand::play(bool on) {
  if (!isOpen()) return;
  if (on && state_.phase == ghost::Phase::Ended) return restart();
  options_.plays = on;
  emit changed();
}

void GhostHand::restart() {
  if (!isOpen()) return;
  ghost::State fresh;
  fresh.last_round = state_.last_round;  // for comparison
  fresh.rounds = state_.rounds;
  state_ = fresh;
  options_.plays = true;
  emit changed();
}

void GhostHand::setMirrored(bool on) {
  if (!isOpen() || on == is_mirrored_) return;
  is_mirrored_ = on;
  ghost_->trajectory = ghost::mirrored(std::move(ghost_->trajectory), ghost_->mirror);
  restart();
}

std::optional<scene::Description> GhostHand::scene() const {
  return is_mirrored_ && ghost_->scene ? scene::mirrored(*ghost_->scene) : ghost_->scene;
}

bool GhostHand::isElsewhere() const {
  const std::optional<scene::Description> recorded = scene();
  return recorded && !hasSameConstraints(*recorded, document_.scene());
}

void GhostHand::add(const servo::TickRecord& record) {
  if (!isOpen() || (record.input & servo::kHadSample) == 0 || !record.p_WT.allFinite()) return;
  p_WT_ = record.p_WT;
  const int rounds = state_.rounds;
  state_ = ghost::advanced(ghost_->trajectory, options_, state_, record.time_ns, record.p_WT);
  if (state_.rounds > rounds) emit ended();
}

void GhostHand::present(const servo::Snapshot&) {
  if (!isOpen() || !state_.tick_ns) return;
  const ghost::StylusPose& now = state_.ghost;
  const bool is_alike = is_drawn_ && (now.p_WG - drawn_.p_WG).norm() + (p_WT_ - drawn_p_WT_).norm() < kLooksTheSame_m &&
                        now.stylus_W == drawn_.stylus_W;
  if (is_alike) return;
  view_.draw("ghost", ghostDrawing(ghost_->trajectory, state_, p_WT_));
  drawn_ = now;
  drawn_p_WT_ = p_WT_;
  is_drawn_ = true;
}

}  // namespace underact::gui
