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

/// Which arm the servo drives. Another one is opened in its own thread while the simulated arm takes its place. The
/// servo is stopped until Start is pressed: an arm that has just been opened must not push anybody.
class ArmChoice : public QObject {
  Q_OBJECT
 public:
  /// chosen: null if arms cannot be exchanged. simulated: the first arm if it is the simulated one, else null.
  ArmChoice(servo::Host& host, Document& document, device::ChosenArm* chosen, device::SimulatedArm* simulated,
            QObject* parent);
  ~ArmChoice() override;

  /// Null while another arm is in use.
  device::SimulatedArm* simulated() const;
  /// The name, as for device::openDevice(): "simulated", "wooden:0042".
  const QString& name() const { return name_; }
  /// The arm requested last, open or not; saved for the next start.
  const QString& wanted() const { return wanted_; }
  /// The arm being opened; empty: none.
  const QString& opening() const { return opening_; }

  /// Starts to open that arm; changed() or failed() follows. Problems: why it is not possible now; nothing changes.
  Problems choose(const QString& name);
  /// Cancels; the simulated arm stays.
  void cancel();

 signals:
  void began();
  void changed();
  void failed(const QString& name, const underact::Problems& problems);

 private:
  using Opened = Result<std::unique_ptr<servo::DevicePort>>;
  Problems refusalNow() const;
  void putFirst();
  void poll();
  void sceneOpened();

  servo::Host& host_;
  Document& document_;
  device::ChosenArm* chosen_;
  device::SimulatedArm* simulated_;
  QString name_ = "simulated", wanted_ = name_, opening_;
  std::string arm_;  // the content of the file of the scene's arm for which the current arm was opened
  std::unique_ptr<Background<Opened>> work_;
  std::vector<std::unique_ptr<Background<Opened>>> leaving_;  // left to finish by themselves
  QTimer poll_timer_;
};

}  // namespace underact::gui
