#pragma once
#include <QSet>
#include <QStringList>
#include <QTranslator>

#include "app/gui/model/language.h"

class QWidget;

namespace underact::gui::test {

/// The window speaks German while it lives, and notes what it was asked for in vain.
class German {
 public:
  German();
  ~German();
  German(const German&) = delete;
  German& operator=(const German&) = delete;
  /// "context: text" of each text of ours that has no translation where it is asked for.
  QStringList missing() const;

 private:
  class Listener;
  Listener* listener_;
};

/// What is seen of a widget and those in it, and has less room than its words need: "name: words".
QStringList cutWords(const QWidget& widget);

}  // namespace underact::gui::test
