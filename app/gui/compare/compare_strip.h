#pragma once
#include <QWidget>

#include "core/record/tick_figures.h"

class QLabel;

namespace underact::gui {

class Actions;

/// Below the two views: the differences between the scenes, the forces of both, and the actions.
class CompareStrip : public QWidget {
  Q_OBJECT
 public:
  /// actions: include those of the comparison.
  CompareStrip(Actions& actions, QWidget* parent);
  void setDifference(const QString& words, const QString& all);
  /// A message; empty: none.
  void tell(const QString& sentence);
  void present(const record::TickFigures& felt, const record::TickFigures& beside);

 private:
  QLabel *difference_, *figures_, *told_;
};

}  // namespace underact::gui
