#pragma once
#include <QObject>
#include <QPointer>
#include <array>
#include <optional>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/theme.h"
#include "app/gui/registration/registration_run.h"
#include "core/registration/registration_file.h"

namespace underact::gui {

class RegistrationWizard;

/// Where the arms stand on the desk: kept for each by its serial number, shown in the view, made anew by a wizard. The
/// picture alone follows: the scene stays in the first arm's frame W, and so do the forces.
class RegistrationTool : public QObject, public Follower {
  Q_OBJECT
 public:
  enum class Which { First, Second };

  explicit RegistrationTool(const FeatureParts& parts);
  ~RegistrationTool() override;
  void add(const servo::TickRecord& record) override;  // of the first arm
  void look(const servo::Snapshot& snapshot) override;
  void setTheme(const Theme& theme) override;

  /// None: it is not registered.
  const std::optional<registration::Registration>& of(Which which) const { return known_[index(which)].registration; }
  /// Whether it is, how well, and what kept it from being read.
  QString sentence(Which which) const;
  /// The arm as people call it.
  QString title(Which which) const;
  bool hasSecond() const;
  /// What the arm's side says is wrong, a calibration that is missing, say; empty: nothing.
  QString trouble(Which which) const;
  /// Why nothing can be touched now; empty: it can.
  QString whyNot() const;
  bool isSimulated(Which which) const;

  /// The arm's ticks are heard by the run from now on, and its force is let go.
  void begin(Which which, std::vector<Vec3> marks_D);
  /// Nothing is touched any more; what was touched is gone, and what was known stays.
  void stopTouching();
  RegistrationRun& run() { return run_; }
  /// The run's result counts from now on, and is kept. Problems: it cannot be kept; it counts until the window closes.
  Problems accept();
  Problems forget(Which which);

 signals:
  void changed();

 private:
  struct Known {
    std::string arm;  // its key
    std::optional<registration::Registration> registration;
    QString why_not;  // it cannot be read
  };
  static std::size_t index(Which which) { return which == Which::First ? 0 : 1; }
  std::string keyOf(Which which) const;
  void recallAll();
  void place();
  void open();

  FeatureParts parts_;
  std::array<Known, 2> known_;
  RegistrationRun run_;
  Which which_ = Which::First;  // of the run
  QPointer<RegistrationWizard> wizard_;
  Theme theme_ = Theme::light();
};

}  // namespace underact::gui
