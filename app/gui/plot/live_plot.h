#pragma once
#include <memory>

#include "app/gui/model/plot_history.h"
#include "app/gui/plot/chart_widget.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// The last 10 s of error [mm] and of force asked and sent [N] against time, and of one axis' displacement against
/// force (thesis figure 4.3); and, of a scene with an influence, of the angles of stylus, tip and target
/// (thesis figure 5.7); and the energy in the constraints [mJ], marked where it is below zero. Every tick goes in; what
/// is drawn is thinned to the widget's width by minimum and maximum, so that a spike of one tick is seen.
class LivePlot : public ChartWidget {
  Q_OBJECT
 public:
  explicit LivePlot(QWidget* parent = nullptr);
  ~LivePlot() override;

  /// Every tick, in order. recorded: drawn beside it, dashed.
  void add(const servo::TickRecord& record, const RecordedBeside& recorded = {});
  void redraw();  // each frame
  void clear();   // another scene
  void setTheme(const Theme& theme);
  void setAxis(int axis);  // 0 x, 1 y, 2 z: of the displacement against force
  int axis() const;
  void showAngles(bool shown);  // a chart of its own; else the others have its room
  bool showsAngles() const;
  void showEnergy(bool shown);
  bool showsEnergy() const;
  /// The line in the force plot, N.
  void setForceLimit(double continuous_N);

 signals:
  void pathShown(bool shown);  // there is room for displacement against force, or not

 protected:
  std::vector<Chart*> shown() const override;
  void place(double scale) override;
  void prepare(bool placed) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
