#pragma once
#include <QObject>
#include <QPointer>
#include <array>
#include <optional>

#include "app/gui/feature/feature.h"
#include "app/gui/registration/registration_run.h"
#include "core/registration/registration_file.h"

namespace underact::gui {

class RegistrationWizard;

/// The registrations of the arms: saved for each by its serial number, shown in the view, renewed by a wizard. Only the
/// picture follows them: the scene and the forces stay in the first arm's frame W.
class RegistrationTool : public QObject, public ServoListener {
  Q_OBJECT
 public:
  enum class Which { First, Second };

  explicit RegistrationTool(const FeatureParts& parts);
  ~RegistrationTool() override;
  void add(const servo::TickRecord& record) override;  // of the first arm
  void poll(const servo::Snapshot& snapshot) override;

  /// None if the arm is not registered.
  const std::optional<registration::Registration>& of(Which which) const { return known_[index(which)].registration; }
  /// Whether the arm is registered, how well, or why its registration could not be read.
  QString sentence(Which which) const;
  /// The arm's name for people.
  QString title(Which which) const;
  bool hasSecond() const;
  /// What the arm reports as wrong, such as a missing calibration; empty: nothing.
  QString trouble(Which which) const;
  /// Why no point can be touched now; empty if it can.
  QString refusalReason() const;
  bool isSimulated(Which which) const;

  /// Stops the servo and passes the arm's ticks to the run from now on.
  void begin(Which which, std::vector<Vec3> points_D);
  /// Ends the touching and discards what was touched; the previous registration stays.
  void stopTouching();
  RegistrationRun& run() { return run_; }
  /// Puts the run's result into use and saves it. Problems: it cannot be saved; it is in use until the window closes.
  Problems accept();
  Problems forget(Which which);

 signals:
  void changed();

 private:
  struct Known {
    std::string arm;  // its key
    std::optional<registration::Registration> registration;
    QString refusal;  // why it cannot be read
  };
  static std::size_t index(Which which) { return which == Which::First ? 0 : 1; }
  std::string keyOf(Which which) const;
  void recallAll();
  void place();

  FeatureParts parts_;
  std::array<Known, 2> known_;
  RegistrationRun run_;
  Which which_ = Which::First;  // of the run
  QPointer<RegistrationWizard> wizard_;
};

}  // namespace underact::gui
