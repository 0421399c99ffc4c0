#pragma once
#include <QListWidget>
#include <QTimer>
#include <vector>

#include "app/gui/gallery/figure_list.h"

namespace underact::gui {

/// The list of figures, each with a thumbnail and its result.
class FigureChooser : public QListWidget {
  Q_OBJECT
 public:
  explicit FigureChooser(QWidget* parent);
  /// Keeps the selection, without a signal.
  void present(const std::vector<FigureRow>& rows);

 private:
  void addNextThumbnail();
  QStringList pictures_;
  QTimer thumbnails_;
  int next_thumbnail_ = 0;
};

}  // namespace underact::gui
