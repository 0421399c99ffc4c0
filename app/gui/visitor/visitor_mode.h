#pragma once
#include <QByteArray>
#include <QFont>
#include <QObject>
#include <QPointer>
#include <QRect>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/background.h"
#include "app/gui/kit/window_chrome.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/visitor/carousel.h"
#include "app/gui/visitor/shown_scenes.h"
#include "app/gui/visitor/visitor_settings.h"
#include "core/servo/host.h"

namespace underact::gui {

class DemonstratorPanel;
class DragHint;
class TitleCard;

/// The window for visitors who are alone with the arm: the view, a title card, scenes in turn and reduced force. All
/// else can be reached only by the demonstrator's key. The card reports a fault; Start turns the force on again. At the
/// end everything is restored.
class VisitorMode : public QObject, public ServoListener {
  Q_OBJECT
 public:
  explicit VisitorMode(const FeatureParts& parts);
  ~VisitorMode() override;

  bool isOn() const { return chrome_.isOff(); }
  void poll(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;
  bool mayClose() const override;
  void leave() override;
  /// The index of the scene shown, from 0, and the scenes.
  std::size_t shown() const { return index_; }
  std::size_t count() const { return scenes_.size(); }

 private:
  struct Before;
  bool start(const QStringList& scenes);
  Problems refusalNow() const;
  void restoreWindow();
  void lock();
  void load(const QStringList& paths);
  void takeLoaded();
  void show(std::size_t index);
  void reset();
  void allowForce();
  void setVisitorSettings(const VisitorSettings& visitor_settings);
  void showPanel();
  bool isTouched(const servo::Snapshot& snapshot, double time_s);
  void presentHints(bool touched);
  void tellState(const servo::Snapshot& snapshot);

  FeatureParts parts_;
  TitleCard* card_;
  DragHint* hint_;
  WindowChrome chrome_;
  std::unique_ptr<Before> before_;
  VisitorSettings visitor_settings_;
  QPointer<DemonstratorPanel> panel_;
  std::unique_ptr<Background<ShownScenes>> load_;
  std::vector<ShownScene> scenes_;
  std::size_t index_ = 0;
  Carousel carousel_;
  QString trouble_;  // why Start failed
  double time_s_ = 0.0, shown_s_ = 0.0, touched_s_ = 0.0, began_s_ = 0.0;
  Vec3 rest_p_WT_ = Vec3::Zero();
  bool pressed_ = false;  // whether a button of the card was pressed since the last frame
};

}  // namespace underact::gui
