#pragma once
#include <memory>

#include "app/gui/model/session_data.h"
#include "app/gui/plot/chart_widget.h"

namespace underact::gui {

/// What of a session is drawn.
enum class SessionPlotKind { ErrorAndForce, ForceAgainstDisplacement, Angles, Energy, Spectrum };

/// A whole session in charts, thinned to the widget's width by minimum and maximum, with a cursor where the replay is.
/// A click into a chart against time asks to go there.
class SessionPlot : public ChartWidget {
  Q_OBJECT
 public:
  explicit SessionPlot(QWidget* parent = nullptr);
  ~SessionPlot() override;
  /// Null: none.
  void setSession(std::shared_ptr<const SessionData> session);
  void setKind(SessionPlotKind kind);
  SessionPlotKind kind() const;
  void setCursor(double time_s);
  void setTheme(const Theme& theme);
  /// Where a time stands, logical pixels; of a kind against time.
  QPointF placeOf(double time_s) const;

 signals:
  void timeAsked(double time_s);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  std::vector<Chart*> shown() const override;
  void place(double scale) override;
  void prepare(bool placed) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
