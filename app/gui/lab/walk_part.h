#pragma once
#include <QElapsedTimer>
#include <QWidget>
#include <optional>
#include <vector>

#include "core/trade/front.h"

class QLabel;
class QPushButton;

namespace underact::gui {

class MarkChart;
class MarkedSlider;
struct Theme;

/// The front of all ways to run a scene, and a slider along it. It shows what holds, and asks for another stop.
class WalkPart : public QWidget {
  Q_OBJECT
 public:
  explicit WalkPart(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// points: the cheapest first; front: those on it, the slider's stops; now: the point in effect, none: another way.
  /// is_measured: something was, be it no front. Gives the point that is shown: while the slider is dragged, its stop.
  std::optional<std::size_t> present(const std::vector<trade::Point>& points, const std::vector<std::size_t>& front,
                                     std::optional<std::size_t> now, bool is_measured);
  void setStop(int stop);
  /// What is chosen, and what differs by it from how the scene was.
  void tell(const QString& chosen, const QString& differences);

 signals:
  void begun();  // what is asked for from now on is a step of its own for undo
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
