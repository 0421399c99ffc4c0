#pragma once
#include <QWidget>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// How far a stick is moved (a line), how much of that comes through (the bar), and the dead zone between.
class AxisBar : public QWidget {
  Q_OBJECT
 public:
  AxisBar(const QString& name, const QString& spoken, QWidget* parent);
  void setTheme(const Theme& theme);
  /// Each -1 to 1; dead_zone: 0 to 1.
  void present(double deflection, double share, double dead_zone);
  double share() const { return share_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Theme theme_ = Theme::light();
  double deflection_ = 0.0, share_ = 0.0, dead_zone_ = 0.0;
};

}  // namespace underact::gui
