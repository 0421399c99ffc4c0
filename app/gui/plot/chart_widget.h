#pragma once
#include <QWidget>
#include <span>
#include <vector>

#include "app/gui/theme.h"

namespace underact::gui {

class Chart;
class GlSurface;

/// A widget full of charts. Which they are and where they stand says who derives from it; it draws when draw() or
/// placeAnew() is called, and only then.
class ChartWidget : public QWidget {
  Q_OBJECT
 public:
  ~ChartWidget() override;
  /// Also where it was never shown.
  QImage picture();

 protected:
  explicit ChartWidget(QWidget* parent);
  /// All charts that may ever be shown. Once.
  void hold(std::span<Chart* const> charts);
  void setBackground(const Theme& theme);
  GlSurface& surface() const { return *surface_; }
  void draw();
  /// Widths, fonts or legends are others: place() comes before the next picture.
  void placeAnew();

  virtual std::vector<Chart*> shown() const = 0;
  /// Puts each of shown() into its place. scale: device pixels a logical one.
  virtual void place(double scale) = 0;
  /// Before each picture. placed: place() was called for it.
  virtual void prepare(bool /*placed*/) {}
  void changeEvent(QEvent* event) override;

 private:
  void before(QSize pixels);
  GlSurface* surface_;
  QSize placed_;
};

}  // namespace underact::gui
