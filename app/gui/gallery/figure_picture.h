#pragma once
#include <QImage>
#include <QPixmap>
#include <QWidget>

namespace underact::gui {

/// A picture scaled to the room available, on white as in print.
class FigurePicture : public QWidget {
  Q_OBJECT
 public:
  explicit FigurePicture(QWidget* parent);
  /// Shows an image file; if it is empty or cannot be read, shows the words instead.
  void setPicture(const QString& path, const QString& words);
  bool hasPicture() const { return !image_.isNull(); }
  QSize sizeHint() const override { return {640, 420}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage image_;
  QString words_;
  QPixmap scaled_;  // image_ at the widget's size
};

}  // namespace underact::gui
