#pragma once
#include <memory>
#include <vector>

#include "app/gui/plot/chart_widget.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// The ticks before a fault: force commanded and sent [N], and latency [us], against the time before it. It is static.
class FaultPlot : public ChartWidget {
  Q_OBJECT
 public:
  explicit FaultPlot(QWidget* parent = nullptr);
  ~FaultPlot() override;
  /// Oldest first; the fault is at the last one.
  void setTicks(const std::vector<servo::TickRecord>& ticks, int rate_hz);
  void setTheme(const Theme& theme);

 protected:
  std::vector<Chart*> shown() const override;
  void place(double scale) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
