#pragma once
#include <QColor>
#include <QImage>
#include <QWidget>
#include <vector>

#include "app/gui/kit/theme.h"

namespace underact::gui {

class Chart;

/// A widget full of charts, painted by Qt into the window's own picture: an OpenGL context of its own, even a shared
/// one, costs software GL 20 MB and a tenth of a second. Which they are and where they stand says who derives from it;
/// it draws when draw() or placeAnew() is called, and only then.
class ChartWidget : public QWidget {
  Q_OBJECT
 public:
  ~ChartWidget() override;
  /// Also where it was never shown.
  QImage picture();
  qint64 framesDrawn() const { return frames_; }

 protected:
  explicit ChartWidget(QWidget* parent);
  void setBackground(const Theme& theme);
  void draw();
  /// Widths, fonts or legends are others: place() comes before the next picture.
  void placeAnew();

  virtual std::vector<Chart*> shown() const = 0;
  /// Puts each of shown() into its place. scale: device pixels a logical one.
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
