#pragma once
#include <QWidget>
#include <memory>

#include "app/gui/replay/session_data.h"
#include "app/gui/theme.h"

namespace underact::gui {

/// What of a session is drawn.
enum class SessionPlotKind { ErrorAndForce, ForceAgainstDisplacement, Angles, Energy, Spectrum };

/// A whole session in charts, thinned to the widget's width by minimum and maximum, with a cursor where the replay is.
/// A click into a chart against time asks to go there.
class SessionPlot : public QWidget {
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
  QImage picture();
  /// Where a time stands, logical pixels; of a kind against time.
  QPointF placeOf(double time_s) const;

 signals:
  void timeAsked(double time_s);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::gui
