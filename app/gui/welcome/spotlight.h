#pragma once
#include <QWidget>
#include <functional>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// A frame that points at a part of the window. It ignores mouse and keys and moves only with its target.
class Spotlight : public QWidget {
  Q_OBJECT
 public:
  /// Where the target is, in window coordinates; empty: not visible.
  using Where = std::function<QRect()>;

  Spotlight(const QString& name, QWidget* window);
  /// The visible part of a widget, in window coordinates.
  static QRect seenRect(const QWidget& target);
  void pointAt(Where where);
  void pointNowhere();
  /// Called each frame, since the target may have moved.
  void follow();
  void setTheme(const Theme& theme);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Where where_;
  QColor line_, edge_;
};

}  // namespace underact::gui
