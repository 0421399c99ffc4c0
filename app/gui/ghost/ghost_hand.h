#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "app/gui/feature/servo_listener.h"
#include "app/gui/ghost/ghost_load.h"
#include "core/ghost/follow.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

class Document;
class LoadStrip;
class Player;
class SceneView;

/// A recorded hand in the view for the user to follow: reads it, moves it tick by tick, and draws it. The arm, the
/// scene and the forces are not affected. Opening a replay ends it.
class GhostHand : public QObject, public ServoListener {
  Q_OBJECT
 public:
  GhostHand(Document& document, Player& player, LoadStrip& loads, SceneView& view, QObject* parent);

  /// Starts to read a session; opened() or failed() follows. false: failed() was emitted at once.
  bool open(const QString& path);
  /// Also cancels one that is being read.
  void close();
  bool isOpen() const { return ghost_.has_value(); }

  // Only while one is open.
  const LoadedGhost& ghost() const { return *ghost_; }
  const ghost::State& state() const { return state_; }
  const ghost::Options& options() const { return options_; }
  void setOptions(const ghost::Options& options);
  /// At the end it starts again.
  void play(bool on);
  bool isPlaying() const { return options_.plays && state_.phase != ghost::Phase::Ended; }
  void restart();
  /// Mirrors it and starts from the beginning; by default as the scenes of the window are.
  void setMirrored(bool on);
  bool isMirrored() const { return is_mirrored_; }
  /// The scene of the recording, mirrored if the ghost is.
  std::optional<scene::Description> scene() const;
  /// Whether the scene in the window is a different one.
  bool isElsewhere() const;

  void add(const servo::TickRecord& record) override;
  void present(const servo::Snapshot& snapshot) override;

 signals:
  void opened();
  void closed();
  void failed(const QString& path, const underact::Problems& problems);
  void changed();  // options, restart
  void ended();    // a round has ended; see state().last_round

 private:
  void begin(LoadedGhost ghost);

  Document& document_;
  Player& player_;
  LoadStrip& loads_;
  SceneView& view_;
  QString reading_;  // being read; empty: none
  std::optional<LoadedGhost> ghost_;
  ghost::Options options_;
  ghost::State state_;
  Vec3 p_WT_ = Vec3::Zero();
  ghost::StylusPose drawn_;  // and p_WT then
  Vec3 drawn_p_WT_ = Vec3::Zero();
  bool is_drawn_ = false, is_mirrored_ = false;
};

}  // namespace underact::gui
