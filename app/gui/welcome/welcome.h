#pragma once
#include <QFrame>
#include <array>
#include <cstdint>
#include <optional>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/theme.h"
#include "core/arm/sample.h"
#include "core/servo/snapshot.h"

class QLabel;

namespace underact::gui {

class Spotlight;

/// The first minute: a card over the view with three things to try. Each is ticked off when done, and the next one is
/// framed; when all are done, the card disappears a little later and comes back only on request. It keeps clear of the
/// stylus; in a low view it has the next thing alone.
class Welcome : public QFrame, public ServoListener {
  Q_OBJECT
 public:
  explicit Welcome(const FeatureParts& parts);
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;
  /// Once all have been done, or the card was closed, it does not come back by itself.
  void remember(Settings& settings) override;

 private:
  enum Thing { Push, Slider, Turn, kThings };
  void build(Actions& actions);
  void ask();
  void close();
  void tell();
  void done(Thing thing, const QString& sentence);
  void watch(const servo::Snapshot& snapshot);
  void tellForce(const tick::TickReport& report);
  void makeRoom();
  void place();
  Thing next() const;
  QRect nextPlace() const;

  SceneView& view_;
  const Hand& hand_;
  Document& document_;
  const Actions& actions_;
  const ServoRate& rate_;
  const ServoFacts servo_;
  Spotlight* spotlight_;
  std::array<QLabel*, kThings> rows_{};
  std::array<bool, kThings> is_done_{};
  QLabel* title_;
  QWidget* purpose_;
  QLabel *confirmed_, *live_;
  bool was_seen_, is_asked_, is_shown_ = false;
  bool is_folded_ = false;  // to the next thing alone, in a low view
  bool edited_ = false;     // since the card was shown
  std::optional<arm::JointAngles> began_rad_;
  std::int64_t leaves_at_tick_ = -1;
};

}  // namespace underact::gui
