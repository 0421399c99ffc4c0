#pragma once
#include <QElapsedTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/tradeoff/front.h"

class QLabel;
class QPushButton;

namespace underact::gui {

class MarkChart;
class MarkedSlider;
struct Theme;

/// The front of the combinations, and a slider along it. It shows the current state and requests another stop.
class WalkPart : public QWidget {
  Q_OBJECT
 public:
  explicit WalkPart(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// points: the cheapest first; front: indices of those on it, the slider's stops; now: index of the current settings,
  /// if among the points; is_measured: there are results, even without a front. Returns the point that is shown: while
  /// the slider is dragged, its stop.
  std::optional<std::size_t> present(const std::vector<tradeoff::Point>& points, const std::vector<std::size_t>& front,
                                     std::optional<std::size_t> now, bool is_measured);
  void setStop(int stop);
  /// The chosen combination, and its differences from the scene as it was.
  void tell(const QString& chosen, const QString& differences);

 signals:
  void begun();  // the changes from now on are one undo step
  /// is_final: the slider was let go, or stepped.
  void stopAsked(int stop, bool is_final);
  void backAsked();

 private:
  void connectSlider();

  MarkChart* chart_;
  MarkedSlider* walk_;
  QLabel *chosen_, *differences_;
  QPushButton* back_;
  QElapsedTimer since_step_;
};

}  // namespace underact::gui
