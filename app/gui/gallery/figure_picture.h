#pragma once
#include <QImage>
#include <QPixmap>
#include <QWidget>

namespace underact::gui {

/// A picture as large as there is room for it, on white as in print.
class FigurePicture : public QWidget {
  Q_OBJECT
 public:
  explicit FigurePicture(QWidget* parent);
  /// An image file; empty, or one that cannot be read: words stand in its place.
  void setPicture(const QString& path, const QString& words);
  bool hasPicture() const { return !image_.isNull(); }
  QSize sizeHint() const override { return {640, 420}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
  QString words_;
  QPixmap scaled_;  // of image_, for the size that the widget has
};

}  // namespace underact::gui
