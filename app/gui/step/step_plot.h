#pragma once
#include <complex>
#include <memory>
#include <vector>

#include "app/gui/plot/chart_widget.h"
#include "core/lab/sampled_response.h"
#include "core/lab/second_order_fit.h"
#include "core/lab/transfer_function.h"

namespace underact::gui {

/// The content of the two charts. Poles, zeros and metrics are those of the first response.
struct StepPicture {
  struct Response {
    QString name;
    lab::TransferFunction transfer;
  };
  std::vector<Response> responses;  // at most kMaxResponses
  double seconds = 1.0;
  lab::StepMetrics metrics;                           // of the first
  std::optional<lab::SampledResponse> measured = {};  // as a fraction of the step
  std::optional<lab::SecondOrderFit> fit = {};
  double steady_error_m = 0.0;  // of the measured response
};

/// Step responses against time, and below them the poles and zeros of the first in the s-plane. Redrawn on request
/// only.
class StepPlot : public ChartWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxResponses = 6;

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
