#pragma once
#include <memory>

#include "app/gui/model/plot_columns.h"
#include "app/gui/model/session_data.h"
#include "app/gui/plot/chart_widget.h"

namespace underact::gui {

/// What is plotted of a session.
enum class SessionPlotKind { ErrorAndForce, ForceAgainstDisplacement, Angles, Energy, Spectrum, Columns };

/// Charts of a whole session, thinned to the widget's width by minimum and maximum, with a cursor at the position of
/// the replay. A click in a chart against time asks to jump there.
class SessionPlot : public ChartWidget {
  Q_OBJECT
 public:
  explicit SessionPlot(QWidget* parent = nullptr);
  ~SessionPlot() override;
  /// Null: none.
  void setSession(std::shared_ptr<const SessionData> session);
  void setKind(SessionPlotKind kind);
  SessionPlotKind kind() const;
  /// What the kind Columns shows; null: nothing.
  void setColumns(std::shared_ptr<const ColumnRows> rows);
  void setCursor(double time_s);
  void setTheme(const Theme& theme);
  /// The point of a time, logical pixels; for a kind against time.
  QPointF placeOf(double time_s) const;

 signals:
  void timeAsked(double time_s);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool isTaken(const QPointF& place) const override;
  std::vector<Chart*> shown() const override;
  void place(double scale) override;
  void prepare(bool placed) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
