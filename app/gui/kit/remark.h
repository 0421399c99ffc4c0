#pragma once
#include <QObject>
#include <QString>
#include <utility>

namespace underact::gui {

/// A sentence set by one part of the window and shown by another.
class Remark : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  const QString& text() const { return text_; }
  void say(const QString& text) {
    if (std::exchange(text_, text) != text) emit changed();
  }

 signals:
  void changed();

 private:
  QString text_;
};

}  // namespace underact::gui
