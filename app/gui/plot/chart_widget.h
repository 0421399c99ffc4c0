#pragma once
#include <QColor>
#include <QImage>
#include <QWidget>
#include <vector>

#include "app/gui/kit/theme.h"

namespace underact::gui {

class Chart;

/// A widget of charts, painted by Qt into the window's own picture: an OpenGL context of its own, even a shared one,
/// costs 20 MB and a tenth of a second with software GL. Derived classes say which charts there are and where; it
/// draws only when draw() or placeAnew() is called.
class ChartWidget : public QWidget {
  Q_OBJECT
 public:
  ~ChartWidget() override;
  /// Also if it was never shown.
  QImage picture();
  qint64 framesDrawn() const { return frames_; }

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
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void paint(QPaintDevice& paper);
  QColor background_;
  QSize placed_;
  qint64 frames_ = 0;
};

}  // namespace underact::gui
