#pragma once
#include <memory>

#include "app/gui/model/plot_history.h"
#include "app/gui/plot/chart_widget.h"
#include "core/arm/preset.h"
#include "core/servo/snapshot.h"

namespace underact::gui {

/// The last 10 s of error [mm] and of force commanded and sent [N] against time, and of force against displacement
/// along one axis (thesis figure 4.3); for a scene with influence, the angles of stylus, tip and target (thesis
/// figure 5.7); and the energy in the constraints [mJ], filled where it is below zero. Every tick goes in; the curves
/// are thinned to the widget's width by minimum and maximum, so that a spike of one tick is seen.
class LivePlot : public ChartWidget {
  Q_OBJECT
 public:
  explicit LivePlot(QWidget* parent = nullptr);
  ~LivePlot() override;

  /// Call with every tick, in order. recorded: drawn as well, dashed.
  void add(const servo::TickRecord& record, const RecordedBeside& recorded = {});
  void redraw();  // each frame
  void clear();   // another scene
  void setTheme(const Theme& theme);
  void setAxis(int axis);  // 0 x, 1 y, 2 z: of force against displacement
  int axis() const;
  void showAngles(bool shown);  // in a chart of its own
  bool showsAngles() const;
  void showEnergy(bool shown);
  bool showsEnergy() const;
  /// Columns of a session in a chart of their own, from now on; empty: none. Indices in plotColumns().
  void showColumns(const std::vector<int>& columns);
  /// Of the arm whose ticks are added, for the columns that say how the stylus is turned.
  void setGeometry(const arm::Geometry& geometry);
  /// Whether the picture stands still, to be read and enlarged; ticks go on being taken.
  void hold(bool on);
  bool holds() const;
  /// The limit line in the force plot, N.
  void setForceLimit(double continuous_N);

 signals:
  void pathShown(bool shown);  // whether there is room for force against displacement

 protected:
  std::vector<Chart*> shown() const override;
  void place(double scale) override;
  void prepare(bool placed) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
