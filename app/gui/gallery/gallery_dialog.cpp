#include "app/gui/gallery/gallery_dialog.h"

#include <QFileDialog>
#include <QIcon>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>

#include "app/gui/gallery/figure_pdf.h"
#include "app/gui/gallery/figure_picture.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

constexpr int kDigits = 6;  // as the page has them

QString numberOrNone(const std::optional<double>& value) {
  return value ? localNumber(*value, 'g', kDigits).replace('-', QChar(0x2212)) : QObject::tr("none");
}

QTableWidgetItem* cell(const QString& text, Qt::Alignment side) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(side | Qt::AlignVCenter);
  return item;
}

/// As high as all thumbnails are, on white, so that the words beside them stand in one line.
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
  icon.addPixmap(thumbnail, QIcon::Selected);  // else the style tints it
  return icon;
}

}  // namespace

GalleryDialog::~GalleryDialog() = default;

QString GalleryDialog::message() const {
  return message_->text();
}

void GalleryDialog::make() {
  if (run_ != nullptr) {
    run_->cancel();
    return;
  }
  run_ = std::make_unique<FiguresRun>(folder_, only_, nullptr);
  connect(run_.get(), &FiguresRun::finished, this, &GalleryDialog::ended);
  connect(run_.get(), &FiguresRun::progressed, this, [this](int number, int of, const QString& figure) {
    progress_->setRange(0, of);
    progress_->setValue(number - 1);
    progress_->setFormat(tr("figure %1 (%2 of %3)").arg(figure).arg(number).arg(of));
  });
  progress_->setRange(0, 0);  // Python has not begun yet
  progress_->show();
  make_->setText(tr("Ca&ncel"));
  make_->setAccessibleName(tr("Cancel"));
  say(tr("The figures are made in the background; the arm and the window go on. It takes about a minute."));
  run_->begin();
}

void GalleryDialog::ended(FiguresRun::End end, const QString& why_not) {
  run_.release()->deleteLater();  // it is the one that calls
  progress_->hide();
  readFolder();
  if (end != FiguresRun::End::Made) say(why_not, end == FiguresRun::End::Failed ? "alarm" : "");
}

void GalleryDialog::readFolder() {
  const Result<FigureList> read = readFigures(folder_);
  list_ = read ? read.value() : FigureList();
  make_->setText(read ? tr("&Make the figures again") : tr("&Make the figures"));
  make_->setAccessibleName(make_->text().remove('&'));
  make_->setDefault(!read);
  page_->setEnabled(static_cast<bool>(read));
  fillList();
  if (!read) {
    say(sentencesOf(read.problems()));
    picture_->setPicture({}, tr("Each scene of the thesis is run with a scripted hand, drawn, and checked in numbers. "
                                "Press “Make the figures”; it takes about a minute."));
    return;
  }
  QString sentence = verdictOf(list_);
  const bool old = list_.program_version != kVersion;
  if (!list_.program_version.isEmpty())
    sentence +=
        ' ' + tr("Made by Underact %1 on %2.").arg(list_.program_version, list_.made.toString("yyyy-MM-dd hh:mm"));
  if (old) sentence += ' ' + tr("This is Underact %1: make them again to see what it does.").arg(kVersion);
  const bool passed =
      std::all_of(list_.rows.begin(), list_.rows.end(), [](const FigureRow& row) { return row.passed; });
  say(sentence, !passed ? "alarm" : old ? "amber" : "");
}

void GalleryDialog::say(const QString& sentence, const char* role) {
  message_->setText(sentence);
  message_->setProperty("role", role);
  message_->setStyleSheet(message_->styleSheet());  // has the style look at the property again
}

void GalleryDialog::fillList() {
  const int before = std::max(figures_->currentRow(), 0);
  figures_->setVisible(!list_.rows.empty());
  {
    const QSignalBlocker silent(figures_);
    figures_->clear();
    for (const FigureRow& row : list_.rows) {
      const QString words = tr("%1  %2\n%3").arg(row.key, row.title, verdictOf(row));
      figures_->addItem(new QListWidgetItem(thumbnailOf({}, figures_->iconSize(), devicePixelRatioF()), words));
    }
    figures_->setCurrentRow(std::min(before, figures_->count() - 1));
  }
  showFigure(figures_->currentRow());
  next_thumbnail_ = 0;
  thumbnails_->start(0);
}

// One at a time: 25 pictures at once would hold the window up for half a second.
void GalleryDialog::addNextThumbnail() {
  if (next_thumbnail_ >= figures_->count()) {
    thumbnails_->stop();
    return;
  }
  const FigureRow& row = list_.rows[static_cast<std::size_t>(next_thumbnail_)];
  figures_->item(next_thumbnail_)->setIcon(thumbnailOf(row.picture, figures_->iconSize(), devicePixelRatioF()));
  ++next_thumbnail_;
}

const FigureRow* GalleryDialog::shown() const {
  const int index = figures_->currentRow();
  return index < 0 ? nullptr : &list_.rows[static_cast<std::size_t>(index)];
}

void GalleryDialog::showFigure(int) {
  const FigureRow* row = shown();
  const FigureRow none;
  if (row == nullptr) row = &none;
  title_->setText(row->key.isEmpty() ? QString() : tr("Figure %1: %2").arg(row->key, row->title));
  caption_->setText(row->caption);
  const bool empty = !row->key.isEmpty() && row->problem.isEmpty() && row->left_out.isEmpty();
  picture_->setPicture(row->picture, empty ? tr("There is no picture.") : row->problem + row->left_out);
  picture_->setAccessibleName(row->key.isEmpty() ? tr("Picture") : title_->text());
  picture_->setAccessibleDescription(row->caption.isEmpty() ? tr("There is no picture.") : row->caption);
  scene_->setEnabled(!row->scene.isEmpty());
  session_->setVisible(ways_.open_session != nullptr);
  session_->setEnabled(!row->session.isEmpty());
  pdf_->setEnabled(picture_->hasPicture());
  showNumbers(*row);
}

void GalleryDialog::showNumbers(const FigureRow& row) {
  numbers_->setRowCount(0);
  numbers_->setVisible(!row.numbers.empty());  // a picture of the view has the room to itself
  for (const FigureNumber& number : row.numbers) {
    const int at = numbers_->rowCount();
    numbers_->insertRow(at);
    int column = 0;
    numbers_->setItem(at, column++, cell(number.what, Qt::AlignLeft));
    for (const std::optional<double>& value : {number.measured, number.expected, number.tolerance})
      numbers_->setItem(at, column++, cell(numberOrNone(value), Qt::AlignRight));
    numbers_->setItem(at, column++, cell(number.unit, Qt::AlignLeft));
    numbers_->setItem(at, column, cell(number.passed ? tr("✓ pass") : tr("✗ fail"), Qt::AlignLeft));
  }
}

void GalleryDialog::choosePdf() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString name = QString("figure_%1.pdf").arg(QString(shown()->key).replace('.', '_'));
  auto* dialog = new QFileDialog(this, tr("Save the figure"), documents, tr("PDF (*.pdf)"));
  dialog->setObjectName("dialog.figures.save");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix("pdf");
  dialog->selectFile(name);
  connect(dialog, &QFileDialog::fileSelected, this, &GalleryDialog::savePdf);
  dialog->open();
}

void GalleryDialog::savePdf(const QString& path) {
  const FigureRow* row = shown();
  if (row == nullptr) return;
  const QString why_not = saveFigurePdf(*row, path);
  say(why_not.isEmpty() ? tr("Figure %1 is in %2").arg(row->key, path) : why_not, why_not.isEmpty() ? "" : "alarm");
}

}  // namespace underact::gui
