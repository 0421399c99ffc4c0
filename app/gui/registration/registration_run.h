#pragma once
#include <QObject>
#include <optional>

#include "core/registration/check.h"
#include "core/registration/error.h"
#include "core/registration/touching.h"
#include "core/servo/host.h"

namespace underact::gui {

/// A registration under way: the reference points, what has been touched so far, and the result.
class RegistrationRun : public QObject {
  Q_OBJECT
 public:
  explicit RegistrationRun(QObject* parent) : QObject(parent) {}

  /// Discards what was touched before and starts with these reference points.
  void begin(std::vector<Vec3> points_D);
  void end();
  bool isOn() const { return touching_.has_value(); }
  /// Called for every tick of the arm.
  void add(const servo::TickRecord& record);
  /// The key, instead of the stylus button.
  void press();
  void touchAgain(std::size_t mark);

  // Only while it is on.
  const registration::Touching& touching() const { return *touching_; }
  /// The position of the tip; none before the first sample.
  const std::optional<Vec3>& p_WT() const { return p_WT_; }
  /// The result of the last press.
  const QString& told() const { return told_; }
  /// Once all reference points have been touched. Problems: why they do not determine a pose.
  Result<registration::Fit> fit() const { return fitTouches(touching_->touches()); }

 signals:
  void changed();

 private:
  void tell(registration::Touching::Event event, std::size_t mark);

  std::optional<registration::Touching> touching_;
  std::optional<Vec3> p_WT_;
  QString told_;
};

}  // namespace underact::gui
