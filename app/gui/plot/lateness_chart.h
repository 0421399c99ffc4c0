#pragma once
#include <array>

#include "app/gui/kit/painted.h"
#include "core/servo/histogram.h"

namespace underact::gui {

/// Histogram of latency, both scales logarithmic, so that one tick in a million is seen.
class LatenessChart : public Painted {
  Q_OBJECT
 public:
  explicit LatenessChart(QWidget* parent = nullptr);
  void present(const servo::Histogram& lateness, double period_us);
  QSize minimumSizeHint() const override;
  /// Ticks in a bar, from 0.
  std::int64_t count(std::size_t bar) const { return counts_[bar]; }
  static constexpr std::size_t kBars = 25;  // five per decade, 1 us to 100 ms; the outer ones count what is beyond

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  double xOf(double lateness_us) const;

  std::array<std::int64_t, kBars> counts_{};
  double period_us_ = 1000.0;
};

}  // namespace underact::gui
