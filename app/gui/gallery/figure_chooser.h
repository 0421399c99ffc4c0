#pragma once
#include <QListWidget>
#include <QTimer>
#include <vector>

#include "app/gui/gallery/figure_list.h"

namespace underact::gui {

/// The figures to choose from, each with a small picture and what came of it.
class FigureChooser : public QListWidget {
  Q_OBJECT
 public:
  explicit FigureChooser(QWidget* parent);
  /// The one that was chosen stays so, silently.
  void present(const std::vector<FigureRow>& rows);

 private:
  void addNextThumbnail();
  QStringList pictures_;
  QTimer thumbnails_;
  int next_thumbnail_ = 0;
};

}  // namespace underact::gui
