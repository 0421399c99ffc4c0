#include "app/gui/gallery/figure_chooser.h"

#include <QIcon>
#include <QImage>
#include <QPainter>
#include <QSignalBlocker>
#include <algorithm>

namespace underact::gui {
namespace {

constexpr QSize kThumbnail(112, 80);

/// On white, all of the same height, so that the texts beside them line up.
QIcon thumbnailOf(const QString& path, const QSize& room, qreal ratio) {
  QPixmap thumbnail(room * ratio);
  thumbnail.fill(Qt::transparent);
  if (!path.isEmpty()) {
    const QImage image = QImage(path).scaled(thumbnail.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter painter(&thumbnail);
    const QRect where(QPoint((thumbnail.width() - image.width()) / 2, (thumbnail.height() - image.height()) / 2),
                      image.size());
    painter.fillRect(where, Qt::white);
    painter.drawImage(where, image);
  }
  thumbnail.setDevicePixelRatio(ratio);
  QIcon icon(thumbnail);
  icon.addPixmap(thumbnail, QIcon::Selected);  // otherwise the style tints it
  return icon;
}

}  // namespace

FigureChooser::FigureChooser(QWidget* parent) : QListWidget(parent) {
  setObjectName("dialog.figures.list");
  setAccessibleName(tr("Figures"));
  setIconSize(kThumbnail);
  setWordWrap(true);
  setResizeMode(QListView::Adjust);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSpacing(2);
  setStyleSheet("QListWidget { show-decoration-selected: 1; }");  // select the whole row with its picture
  setMinimumWidth(kThumbnail.width() + 12 * fontMetrics().averageCharWidth());
  connect(&thumbnails_, &QTimer::timeout, this, &FigureChooser::addNextThumbnail);
}

void FigureChooser::present(const std::vector<FigureRow>& rows) {
  const int before = std::max(currentRow(), 0);
  const QSignalBlocker silent(this);
  setVisible(!rows.empty());
  clear();
  pictures_.clear();
  for (const FigureRow& row : rows) {
    const QString words = tr("%1  %2\n%3").arg(row.key, row.title, verdictOf(row));
    addItem(new QListWidgetItem(thumbnailOf({}, iconSize(), devicePixelRatioF()), words));
    pictures_ << row.picture;
  }
  setCurrentRow(std::min(before, count() - 1));
  next_thumbnail_ = 0;
  thumbnails_.start(0);
}

// One at a time: 25 pictures at once would block the window for half a second.
void FigureChooser::addNextThumbnail() {
  if (next_thumbnail_ >= count()) {
    thumbnails_.stop();
    return;
  }
  item(next_thumbnail_)->setIcon(thumbnailOf(pictures_[next_thumbnail_], iconSize(), devicePixelRatioF()));
  ++next_thumbnail_;
}

}  // namespace underact::gui
