#pragma once
#include <QWidget>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// A widget that paints itself in the theme's colours, on the background of its panel.
class Painted : public QWidget {
  Q_OBJECT
 public:
  void setTheme(const Theme& theme);

 protected:
  Painted(const QString& name, const QString& spoken, const QString& tip, QWidget* parent);
  /// The colour blended with the background by that share.
  QColor ink(double share) const { return mixed(palette().color(QPalette::Window), theme_.ink, share); }
  QColor quiet(double share) const { return mixed(palette().color(QPalette::Window), theme_.quiet, share); }

  Theme theme_ = Theme::light();
};

}  // namespace underact::gui
