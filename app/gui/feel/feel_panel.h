#pragma once
#include <array>

#include "app/gui/feature/panel.h"
#include "core/scene/settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace underact::gui {

class GainRow;
class InfluenceSection;
class RateSection;
class GuideSection;
class SurfaceSection;

/// What the constraint feels like: law and gains, changed while the hand is on the stylus.
class FeelPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    ServoFacts servo;
    Document& document;
    Actions& actions;
    ServoRate& rate;
  };
  FeelPanel(const Parts& parts, QWidget* parent);
  void present(const servo::Snapshot& snapshot) override;

  /// One gain, as the sliders do it. gain: 0 kp, 1 kd, 2 ki; axis: 0 x, 1 y, 2 z; fresh: a step of its own for undo.
  /// false: refused.
  bool setGain(int gain, int axis, double value, bool fresh);
  /// A setting of the constraint shown, by its path from there on: "/control/law".
  bool set(const std::string& path, const scene::SettingValue& value, bool fresh);
  /// Of the constraint shown; none: position only. what: for the undo menu.
  bool setInfluence(const std::optional<scene::Influence>& influence, const QString& what, bool fresh);
  /// Of the constraint shown; none: smooth.
  bool setFriction(const std::optional<scene::Friction>& friction, const QString& what, bool fresh);
  /// Of the curve shown; none: nobody leads.
  bool setGuide(const std::optional<scene::CurveGuide>& guide, const QString& what, bool fresh);
  /// The whole control, the influence, the friction and the guide of the constraint shown, as the file has them.
  bool resetToScene();

 private:
  void buildChoices(QVBoxLayout* column);
  void buildGains(QVBoxLayout* column);
  void buildFoot(QVBoxLayout* outer);
  void addActions();
  bool hasScene() const;
  void sceneOpened();
  void sceneEdited();
  void refresh();
  void beginInfluence();
  void refreshInfluence();
  void refreshSurface();
  void addSwitches();
  void refreshWarnings(const scene::Control& control);
  void addCommand(const QString& name, const std::string& path);
  scene::Description asWritten() const;
  bool setAs(const QString& what, const std::string& path, const scene::SettingValue& value, bool fresh);
  bool refuse(const Problems& problems);
  bool sendScene(const scene::Description& edited, const QString& what, bool fresh);

  Parts parts_;
  std::size_t index_ = 0;  // of the constraint whose control is shown
  int gesture_ = 0;
  bool stale_ = true;  // what is shown may not be what holds
  QFormLayout* choices_ = nullptr;
  QComboBox* constraint_ = nullptr;
  QComboBox* law_ = nullptr;
  QComboBox* anisotropy_ = nullptr;
  QComboBox* space_ = nullptr;
  QCheckBox* link_ = nullptr;
  QLabel* refusal_ = nullptr;
  QLabel* warning_ = nullptr;
  std::array<QWidget*, 3> sections_{};
  std::array<std::array<GainRow*, 3>, 3> rows_{};
  InfluenceSection* influence_ = nullptr;
  RateSection* rate_ = nullptr;
  SurfaceSection* surface_ = nullptr;
  GuideSection* guide_ = nullptr;
};

}  // namespace underact::gui
