#pragma once
#include "app/gui/feature/panel.h"

class QLabel;
class QListWidget;
class QPushButton;

namespace underact::gui {

class MapEditor;
class InputDevices;

/// The input devices, which of them move the stylus, and the mapping of a controller or 3D mouse.
class InputDevicesPanel : public Panel {
  Q_OBJECT
 public:
  struct Parts {
    QMainWindow* window;
    ServoFacts servo;
    Actions& actions;
    Hand& hand;
    std::vector<device::input::DeviceEnumerator*> hands;
  };
  InputDevicesPanel(const Parts& parts, QWidget* parent);
  void before() override;
  void present(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

 private:
  void addActions();
  QString current() const;
  void rebuild();
  void describe();
  bool fix();

  Parts parts_;
  InputDevices& hands_;  // of the window
  QLabel *state_ = nullptr, *trouble_ = nullptr, *about_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton* fix_ = nullptr;
  MapEditor* editor_ = nullptr;
};

}  // namespace underact::gui
