#pragma once
#include <complex>
#include <memory>
#include <vector>

#include "app/gui/plot/chart_widget.h"
#include "core/lab/curve.h"
#include "core/lab/second_order_fit.h"
#include "core/lab/transfer_function.h"

namespace underact::gui {

/// What the two charts show. The first response is the one whose poles, zeros and metrics they mark.
struct StepPicture {
  struct Response {
    QString name;
    lab::TransferFunction transfer;
  };
  std::vector<Response> responses;  // at most kMostResponses
  double seconds = 1.0;
  lab::StepMetrics metrics;                 // of the first
  std::optional<lab::Curve> measured = {};  // a share of the step
  std::optional<lab::SecondOrderFit> fit = {};
  double steady_error_m = 0.0;  // of what was measured
};

/// Step responses against time, and below them the poles and zeros of the first in the s-plane. It moves when asked.
class StepPlot : public ChartWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t kMostResponses = 6;

  explicit StepPlot(QWidget* parent = nullptr);
  ~StepPlot() override;
  void present(const StepPicture& picture);
  void setTheme(const Theme& theme);
  QSize minimumSizeHint() const override;

 protected:
  std::vector<Chart*> shown() const override;
  void place(double scale) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
