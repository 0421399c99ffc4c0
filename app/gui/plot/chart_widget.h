#pragma once
#include <QColor>
#include <QImage>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/gui/kit/theme.h"

class QMenu;

namespace underact::gui {

class Chart;

// A moving hand needs 60 frames per second, a plot is readable at 20: the rest of the time is left to the servo.
inline constexpr int kFramesAPlot = 3;

/// A widget of charts, painted by Qt into the window's own picture: an OpenGL context of its own, even a shared one,
/// costs 20 MB and a tenth of a second with software GL. Derived classes say which charts there are and where; it
/// draws only when draw() or placeAnew() is called.
///
/// In each of them the pointer reads the values; the wheel enlarges along x, with Ctrl along y; Shift and a drag
/// enlarges a rectangle; a drag moves what is enlarged; a double click shows all. With the keyboard: + and -, the
/// arrows, Home. The context menu copies or saves the picture and the data.
class ChartWidget : public QWidget {
  Q_OBJECT
 public:
  ~ChartWidget() override;
  /// Also if it was never shown.
  QImage picture();
  qint64 framesDrawn() const { return frames_; }

  /// Enlarges about a point of the widget, by factors along x and y; 2: half as much is seen.
  void enlarge(const QPointF& about, double along_x, double along_y);
  /// Shows all of each chart.
  void showAll();
  /// Whether any chart shows a part only.
  bool showsPart() const;
  /// What is under the pointer there, or everything that is drawn, as text; empty: no chart is there.
  QString readingsAt(const QPointF& place) const;
  QString dataText(QChar separator) const;

 public slots:
  void copyPicture();
  void copyData();

 signals:
  void partChanged();

 protected:
  explicit ChartWidget(QWidget* parent);
  void setBackground(const Theme& theme);
  void draw();
  /// Widths, fonts or legends have changed: place() is called before the next picture.
  void placeAnew();

  virtual std::vector<Chart*> shown() const = 0;
  /// Sets the place of each of shown(). scale: device pixels per logical one.
  virtual void place(double scale) = 0;
  /// Before each picture. placed: place() was called for it.
  virtual void prepare(bool /*placed*/) {}
  /// Whether a click or a drag there with the left button means something else than to move what is seen.
  virtual bool isTaken(const QPointF& /*place*/) const { return false; }
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void paint(QPaintDevice& paper, bool is_on_screen);
  void paintCursor(QPainter& painter) const;
  Chart* chartAt(const QPointF& place) const;
  /// The other charts of the same x, which show the same part of it, and the chart itself.
  std::vector<Chart*> linkedTo(const Chart& chart) const;
  void move(Chart& chart, const QPointF& by_px);
  void enlargeRectangle();
  void saveData();

  QColor background_, ink_;
  QSize placed_;
  qint64 frames_ = 0;
  std::optional<QPointF> pointer_;  // over the widget
  std::optional<QPointF> pressed_;  // where a drag of ours began
  QPointF last_;
  bool is_rectangle_ = false;
};

}  // namespace underact::gui
