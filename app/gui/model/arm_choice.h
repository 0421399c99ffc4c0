#pragma once
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/gui/kit/background.h"
#include "core/servo/host.h"

namespace underact::device {
class ChosenArm;
class SimulatedArm;
}  // namespace underact::device

namespace underact::gui {

class Document;

/// Which arm the servo drives. Another one is opened in a thread of its own, with the simulated arm in its place
/// meanwhile; the servo is stopped then, and Start goes on: nobody is pushed by an arm that has just been opened.
class ArmChoice : public QObject {
  Q_OBJECT
 public:
  /// chosen: where arms can be exchanged, else null. simulated: the first arm where it is the simulated one, else null.
  ArmChoice(servo::Host& host, Document& document, device::ChosenArm* chosen, device::SimulatedArm* simulated,
            QObject* parent);
  ~ArmChoice() override;

  /// Null while another arm is in place.
  device::SimulatedArm* simulated() const;
  /// As device::openDevice() takes it: "simulated", "wooden:0042".
  const QString& name() const { return name_; }
  /// That was asked for last, open or not: for the next life of the window.
  const QString& wanted() const { return wanted_; }
  /// That is being opened; empty: none.
  const QString& opening() const { return opening_; }

  /// Opens that arm, in a while: changed() or failed() comes. Problems: why it cannot be now; then nothing changes.
  Problems choose(const QString& name);
  /// The simulated arm stays.
  void cancel();

 signals:
  void began();
  void changed();
  void failed(const QString& name, const underact::Problems& problems);

 private:
  using Opened = Result<std::unique_ptr<servo::DevicePort>>;
  Problems whyNotNow() const;
  void putFirst();
  void look();
  void sceneOpened();

  servo::Host& host_;
  Document& document_;
  device::ChosenArm* chosen_;
  device::SimulatedArm* simulated_;
  QString name_ = "simulated", wanted_ = name_, opening_;
  std::string arm_;  // of the scene that the arm in place was opened for
  std::unique_ptr<Background<Opened>> work_;
  std::vector<std::unique_ptr<Background<Opened>>> leaving_;  // nobody waits for them
  QTimer looks_;
};

}  // namespace underact::gui
