#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "app/gui/feature/follower.h"
#include "app/gui/ghost/ghost_load.h"
#include "core/follow/follow.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

class Document;
class LoadStrip;
class Player;
class SceneView;

/// A recorded hand in the view that the one who holds the stylus follows: reads it, lets it go tick by tick, and draws
/// it. The arm, the scene and the forces stay what they are. A replay that opens ends it.
class GhostHand : public QObject, public Follower {
  Q_OBJECT
 public:
  GhostHand(Document& document, Player& player, LoadStrip& loads, SceneView& view, QObject* parent);

  /// Begins to read a session; opened() or failed() tells how it went. false: why is told at once.
  bool open(const QString& path);
  /// One that is being read, too.
  void close();
  bool isOpen() const { return ghost_.has_value(); }

  // Where one is open.
  const LoadedGhost& ghost() const { return *ghost_; }
  const follow::State& state() const { return state_; }
  const follow::Options& options() const { return options_; }
  void setOptions(const follow::Options& options);
  /// At its end it begins again.
  void play(bool on);
  bool isPlaying() const { return options_.plays && state_.phase != follow::Phase::Ended; }
  void restart();
  /// Left to right, from its beginning; at first it is as the window's scenes are.
  void setMirrored(bool on);
  bool isMirrored() const { return is_mirrored_; }
  /// The scene that it was recorded in, mirrored where the ghost is.
  std::optional<scene::Description> scene() const;
  /// The one in the window is another.
  bool isElsewhere() const;

  void add(const servo::TickRecord& record) override;
  void present(const servo::Snapshot& snapshot) override;

 signals:
  void opened();
  void closed();
  void failed(const QString& path, const underact::Problems& problems);
  void changed();  // options, restart
  void ended();    // a round; state().last_round has it

 private:
  void begin(LoadedGhost ghost);

  Document& document_;
  Player& player_;
  LoadStrip& loads_;
  SceneView& view_;
  QString reading_;  // that is read now; empty: none
  std::optional<LoadedGhost> ghost_;
  follow::Options options_;
  follow::State state_;
  Vec3 p_WT_ = Vec3::Zero();
  follow::Place drawn_;  // and p_WT then
  Vec3 drawn_p_WT_ = Vec3::Zero();
  bool is_drawn_ = false, is_mirrored_ = false;
};

}  // namespace underact::gui
