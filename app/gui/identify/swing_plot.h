#pragma once
#include <memory>

#include "app/gui/identify/swing_picture.h"
#include "app/gui/plot/chart_widget.h"

namespace underact::gui {

/// Swings against time: the target, the tip, and the fitted body. Redrawn on request only.
class SwingPlot : public ChartWidget {
  Q_OBJECT
 public:
  SwingPlot(const QString& object_name, QWidget* parent);
  ~SwingPlot() override;
  void present(const SwingPicture& picture);
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
