#pragma once
#include "app/gui/kit/painted.h"

namespace underact::gui {

/// The deflection of a stick (line), the resulting share of the speed (bar) and the dead zone.
class AxisBar : public Painted {
  Q_OBJECT
 public:
  AxisBar(const QString& name, const QString& spoken, QWidget* parent);
  /// Each -1 to 1; dead_zone: 0 to 1.
  void present(double deflection, double share, double dead_zone);
  double share() const { return share_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double deflection_ = 0.0, share_ = 0.0, dead_zone_ = 0.0;
};

}  // namespace underact::gui
