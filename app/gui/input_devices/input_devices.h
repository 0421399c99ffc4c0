#pragma once
#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "app/gui/input_devices/learning.h"
#include "app/gui/input_devices/map_store.h"
#include "app/gui/model/servo_facts.h"
#include "device/input/device_enumerator.h"

class QWidget;

namespace underact::gui {

class Actions;
class Hand;

/// An input device as the window knows it.
struct InputDeviceEntry {
  device::input::DeviceState seen;
  device::input::Map map;
  device::input::ReadyAxes awake;
  bool used = true;    // ticked in the panel
  bool moves = false;  // deflected at this moment
  QString id() const { return QString::fromStdString(seen.id); }
};

/// The controllers and 3D mice that are plugged in, their mappings, and the motion of the simulated hand by them. They
/// move it only while the simulated arm is in use, no recording is replayed and the window is active; Stop always
/// works. Motions are integrated over the arm's time, so that tests move the hand equally far on any machine.
class InputDevices : public QObject {
  Q_OBJECT
 public:
  /// ports: none if the window has only mouse and keyboard. They outlive this object.
  InputDevices(ServoFacts servo, Hand& hand, std::vector<device::input::DeviceEnumerator*> ports, Actions& actions,
               QWidget* window);
  ~InputDevices() override;

  /// Reads the devices and moves the hand: each frame, and between frames.
  void poll();
  const std::vector<InputDeviceEntry>& entries() const { return entries_; }
  /// Null: not plugged in.
  const InputDeviceEntry* find(const QString& id) const;
  /// Why the devices have no effect, in a sentence; empty: they have.
  QString restReason() const;
  /// Problems of GLFW and of the map files.
  QString trouble() const;

  void use(const QString& id, bool on);
  /// Undoable. fresh false: one undo step with the last change of the same field. False: not plugged in.
  bool change(const QString& id, const device::input::Map& map, const QString& field, bool fresh = true);
  bool reset(const QString& id);
  QUndoStack& undoStack() { return undo_; }

  /// Assigns the next stick that is pushed far, or button that is pressed, to a way or button ("right", "stop").
  bool learn(const QString& id, const QString& field);
  void endLearning();
  /// The field that is being learnt, and the instruction for the user; empty: none.
  QString learning() const { return learning_ ? learning_->field() : QString(); }
  QString asked() const { return learning_ ? learning_->asked() : QString(); }

 signals:
  void changed();  // devices, switches, maps or learning

 private:
  void setMap(const QString& id, const device::input::Map& map);
  bool takeSeen();
  void take(device::input::DeviceState seen, std::vector<InputDeviceEntry>& now, bool& is_new);
  void readMap(InputDeviceEntry& entry);
  void goOnLearning();
  void move(const device::input::Motion& motion, double dt_s);
  void save();

  ServoFacts servo_;
  Hand& hand_;
  const std::vector<device::input::DeviceEnumerator*> ports_;
  Actions& actions_;
  QWidget* window_;
  MapStore store_;
  std::vector<InputDeviceEntry> entries_;
  std::set<QString> unused_, unsaved_;
  std::map<QString, device::input::MapFile> maps_;  // of all devices seen so far, with their names
  std::map<QString, device::input::Map> defaults_;
  std::map<QString, QString> problems_;  // by device
  QUndoStack undo_;
  QString gestured_;  // device and field of the last change
  int gesture_ = 0;
  std::optional<Learning> learning_;
  QTimer poll_timer_, saves_, gives_up_;
  std::int64_t time_ns_ = -1;  // of the arm, at the last look
  bool moved_ = false, stops_ = false;
};

}  // namespace underact::gui
