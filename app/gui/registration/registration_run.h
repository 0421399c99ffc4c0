#pragma once
#include <QObject>
#include <optional>

#include "core/registration/check.h"
#include "core/registration/error.h"
#include "core/registration/touching.h"
#include "core/servo/host.h"

namespace underact::gui {

/// A registration that is being made: which arm, which marks, what was touched so far, what came of it.
class RegistrationRun : public QObject {
  Q_OBJECT
 public:
  explicit RegistrationRun(QObject* parent) : QObject(parent) {}

  /// From now on the ticks of that arm are heard; what was touched before is gone.
  void begin(std::vector<Vec3> marks_D);
  void end();
  bool isOn() const { return touching_.has_value(); }
  /// Every tick of the arm.
  void add(const servo::TickRecord& record);
  /// The key, in place of the stylus's button.
  void press();
  void touchAgain(std::size_t mark);

  // Where it is on.
  const registration::Touching& touching() const { return *touching_; }
  /// Where the tip is; none: no sample came.
  const std::optional<Vec3>& p_WT() const { return p_WT_; }
  /// What became of the last press.
  const QString& told() const { return told_; }
  /// Once all marks are touched. Problems: why they tell no pose.
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
