#pragma once
#include <QWidget>

#include "app/gui/gallery/figure_list.h"

class QLabel;
class QTableWidget;

namespace underact::gui {

class FigurePicture;

/// One figure: its title, picture and caption, and the numbers checked in it.
class FigureSheet : public QWidget {
  Q_OBJECT
 public:
  explicit FigureSheet(QWidget* parent);
  /// A row without a key means no figure.
  void present(const FigureRow& row);
  /// Shows words in place of the picture.
  void say(const QString& words);
  bool hasPicture() const;

 private:
  void showNumbers(const FigureRow& row);

  QLabel *title_, *caption_;
  FigurePicture* picture_;
  QTableWidget* numbers_;
};

}  // namespace underact::gui
