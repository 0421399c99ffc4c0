#pragma once
#include <QWidget>

#include "core/record/tick_figures.h"

class QLabel;

namespace underact::gui {

class Actions;

/// Below the two views: what the scenes do not share, the forces of both, and what can be done with them.
class CompareStrip : public QWidget {
  Q_OBJECT
 public:
  /// actions: with those of the comparison.
  CompareStrip(Actions& actions, QWidget* parent);
  void setDifference(const QString& words, const QString& all);
  /// A sentence that should be seen; empty: none.
  void tell(const QString& sentence);
  void present(const record::TickFigures& felt, const record::TickFigures& beside);

 private:
  QLabel *difference_, *figures_, *told_;
};

}  // namespace underact::gui
