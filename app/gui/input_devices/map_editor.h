#pragma once
#include <QWidget>
#include <array>

#include "app/gui/kit/theme.h"
#include "device/input/motion.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace underact::gui {

class Actions;
class AxisBar;
class InputDevices;
class PressRows;
class ValueRow;
struct InputDeviceEntry;

/// The mapping of one device: what each stick and button does, and its present deflection.
class MapEditor : public QWidget {
  Q_OBJECT
 public:
  MapEditor(InputDevices& hands, Actions& actions, QWidget* parent);
  void setDevice(const QString& id);
  void setTheme(const Theme& theme);
  /// Shows the map.
  void rebuild();
  /// Updates the bars, each frame.
  void present();

 private:
  void buildMotionAxes(QGridLayout* grid);
  QWidget* buildOne();
  QWidget* buildFoot();
  void chooseMotionAxis(std::size_t motion);
  const InputDeviceEntry* entry() const;
  QString field(const char* part) const;
  void set(const QString& field, const QVariant& value, bool fresh = true);
  void learn(const QString& field);
  void fillSources(const InputDeviceEntry& entry);
  void presentLearning();

  InputDevices& hands_;
  Actions& actions_;
  QString id_;
  std::size_t motion_ = 0;
  QLabel *title_, *motion_title_ = nullptr, *asked_ = nullptr;
  std::array<QToolButton*, device::input::kMotionAxes> motions_{};
  std::array<AxisBar*, device::input::kMotionAxes> bars_{};
  QComboBox* source_ = nullptr;
  QCheckBox* inverted_ = nullptr;
  QPushButton *learn_ = nullptr, *undo_ = nullptr, *redo_ = nullptr, *reset_ = nullptr;
  ValueRow *zone_ = nullptr, *fine_ = nullptr, *speed_ = nullptr, *turn_speed_ = nullptr;
  PressRows* presses_ = nullptr;
};

}  // namespace underact::gui
