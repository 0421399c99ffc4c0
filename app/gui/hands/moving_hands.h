#pragma once
#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "app/gui/hands/learning.h"
#include "app/gui/hands/map_store.h"
#include "app/gui/model/servo_facts.h"
#include "device/hands/port.h"

class QWidget;

namespace underact::gui {

class Actions;
class Hand;

/// A hand's device as the window knows it.
struct HandEntry {
  device::hands::Seen seen;
  device::hands::Map map;
  device::hands::Awake awake;
  bool used = true;    // its switch
  bool moves = false;  // it asks for something at this moment
  QString id() const { return QString::fromStdString(seen.id); }
};

/// The controllers and 3D mice that are there, what each part of them does, and the simulated hand moved by them: any
/// that moves moves it. Only while the simulated arm is in place, no recording is replayed and the window is the active
/// one; Stop works always. Time is the arm's, so that a story's hand moves as far on any machine.
class MovingHands : public QObject {
  Q_OBJECT
 public:
  /// ports: none where the window has mouse and keyboard alone. They outlive it.
  MovingHands(ServoFacts servo, Hand& hand, std::vector<device::hands::Port*> ports, Actions& actions, QWidget* window);
  ~MovingHands() override;

  /// Each frame, and between two.
  void look();
  const std::vector<HandEntry>& entries() const { return entries_; }
  /// Null: it is not plugged in.
  const HandEntry* find(const QString& id) const;
  /// Why the hands rest, in a sentence; empty: they do not.
  QString whyAtRest() const;
  /// Of GLFW, of files of maps.
  QString trouble() const;

  void use(const QString& id, bool on);
  /// Undoable. fresh false: goes with the last change of the same field. false: it is not plugged in.
  bool change(const QString& id, const device::hands::Map& map, const QString& field, bool fresh = true);
  bool reset(const QString& id);
  QUndoStack& undoStack() { return undo_; }

  /// The next stick that is pushed far, or button that is pressed, is the one for that way or button ("right", "stop").
  bool learn(const QString& id, const QString& field);
  void endLearning();
  /// The field that is being learnt, and what the person is asked for; empty: none.
  QString learning() const { return learning_ ? learning_->field() : QString(); }
  QString asked() const { return learning_ ? learning_->asked() : QString(); }

 signals:
  void changed();  // which there are, a switch, a map, what is learnt

 private:
  void setMap(const QString& id, const device::hands::Map& map);
  bool takeSeen();
  void take(device::hands::Seen seen, std::vector<HandEntry>& now, bool& is_new);
  void readMap(HandEntry& entry);
  void goOnLearning();
  void move(const device::hands::Motion& motion, double dt_s);
  void save();

  ServoFacts servo_;
  Hand& hand_;
  const std::vector<device::hands::Port*> ports_;
  Actions& actions_;
  QWidget* window_;
  MapStore store_;
  std::vector<HandEntry> entries_;
  std::set<QString> unused_, unsaved_;
  std::map<QString, device::hands::MapFile> maps_;  // of all that were there; their names, too
  std::map<QString, device::hands::Map> usual_;
  std::map<QString, QString> problems_;  // by device
  QUndoStack undo_;
  QString gestured_;  // the field that was changed last, and of which device
  int gesture_ = 0;
  std::optional<Learning> learning_;
  QTimer looks_, saves_, gives_up_;
  std::int64_t time_ns_ = -1;  // of the arm, at the last look
  bool moved_ = false, stops_ = false;
};

}  // namespace underact::gui
