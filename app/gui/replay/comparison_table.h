#pragma once
#include <QWidget>
#include <array>

#include "app/gui/model/comparison.h"

class QGridLayout;
class QLabel;

namespace underact::gui {

/// What if: RMS error, maximum and mean force, as recorded and now.
class ComparisonTable : public QWidget {
  Q_OBJECT
 public:
  explicit ComparisonTable(QWidget* parent);
  /// rate_hz: of the servo.
  void present(const Comparison& comparison, int rate_hz);

 private:
  QLabel* cell(const char* name, const QString& spoken);
  void fill(const std::array<QLabel*, 3>& cells, const record::TickFigures& figures);

  std::array<QLabel*, 3> recorded_{}, now_{};
  QLabel* stretch_;
};

}  // namespace underact::gui
