#pragma once
#include <QWidget>
#include <functional>

#include "app/gui/kit/theme.h"

namespace underact::gui {

/// A frame around a part of the window, to point at it. Takes no mouse and no keys; nothing moves but with its target.
class Spotlight : public QWidget {
  Q_OBJECT
 public:
  /// Where the target is, in the window's coordinates; empty: nowhere to be seen.
  using Where = std::function<QRect()>;

  Spotlight(const QString& name, QWidget* window);
  /// The part of a widget that is seen, in its window's coordinates.
  static QRect seenRect(const QWidget& target);
  void pointAt(Where where);
  void pointNowhere();
  /// Each frame: the target may have moved.
  void follow();
  void setTheme(const Theme& theme);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Where where_;
  QColor line_, edge_;
};

}  // namespace underact::gui
