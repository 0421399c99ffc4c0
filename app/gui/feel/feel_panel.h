#pragma once
#include "app/gui/feature/panel.h"
#include "core/scene/settings.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QVBoxLayout;

namespace underact::gui {

class FeelFoot;
class GainSection;
class OptionalSection;
class SettingRows;
struct SettingChange;

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

  /// Sets one gain, as a slider does. gain: 0 kp, 1 kd, 2 ki; axis: 0 x, 1 y, 2 z; fresh: a separate undo step. False:
  /// refused.
  bool setGain(int gain, int axis, double value, bool fresh);
  /// Sets a setting of the shown constraint, by its path relative to the constraint ("/control/law"), and others that
  /// depend on it.
  bool set(const std::string& path, const scene::SettingValue& value, bool fresh);
  /// Restores control, influence, friction and guidance of the shown constraint to the values in the scene file.
  bool resetToScene();

 private:
  void buildChoices(QVBoxLayout* column);
  void buildSections(QVBoxLayout* column);
  void addActions();
  void addCommand(const QString& name, const std::string& path);
  void addSwitch(const QString& name, OptionalSection* section);
  void choose(int row);
  bool hasScene() const;
  void sceneOpened();
  void sceneEdited();
  void begin();
  void refresh();
  void refreshWarnings(const scene::Control& control);
  bool isIdle(const std::string& path) const;
  std::vector<SettingChange> withCompany(const std::string& path, const scene::SettingValue& value) const;
  scene::Description asWritten() const;
  /// what: the text of the undo menu.
  bool setAll(const QString& what, const std::vector<SettingChange>& changes, bool fresh);
  bool refuse(const Problems& problems);
  bool sendScene(const scene::Description& edited, const QString& what, bool fresh);

  Parts parts_;
  std::size_t index_ = 0;  // of the shown constraint
  int gesture_ = 0;
  bool stale_ = true;  // the panel may differ from the scene
  SettingRows* rows_;
  GainSection* gains_;
  FeelFoot* foot_ = nullptr;
  QFormLayout* choices_ = nullptr;
  QComboBox* constraint_ = nullptr;
  OptionalSection *influence_ = nullptr, *surface_ = nullptr, *guide_ = nullptr;
  QCheckBox* backwards_ = nullptr;  // direction of the guide
};

}  // namespace underact::gui
