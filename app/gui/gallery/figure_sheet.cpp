#include "app/gui/gallery/figure_sheet.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/gallery/figure_picture.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"

namespace underact::gui {
namespace {

constexpr int kDigits = 6;  // as on the HTML page

QString numberOrNone(const std::optional<double>& value) {
  return value ? localNumber(*value, 'g', kDigits).replace('-', QChar(0x2212)) : QObject::tr("none");
}

QTableWidgetItem* cell(const QString& text, Qt::Alignment side) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(side | Qt::AlignVCenter);
  return item;
}

}  // namespace

FigureSheet::FigureSheet(QWidget* parent)
    : QWidget(parent),
      title_(messageLabel("dialog.figures.title", tr("Figure"), "section", this)),
      caption_(messageLabel("dialog.figures.caption", tr("Caption"), "", this)),
      picture_(new FigurePicture(this)),
      numbers_(new QTableWidget(0, 6, this)) {
  picture_->setObjectName("dialog.figures.picture");
  numbers_->setObjectName("dialog.figures.numbers");
  numbers_->setAccessibleName(tr("Numbers checked in the figure"));
  numbers_->setHorizontalHeaderLabels(
      {tr("Number"), tr("Measured"), tr("Expected"), tr("Tolerance"), tr("Unit"), tr("Result")});
  numbers_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  numbers_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  numbers_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  numbers_->verticalHeader()->hide();
  numbers_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  numbers_->setShowGrid(false);
  numbers_->setWordWrap(true);
  numbers_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  numbers_->setSelectionBehavior(QAbstractItemView::SelectRows);
  numbers_->setTabKeyNavigation(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(picture_, 3);
  column->addWidget(caption_);
  column->addWidget(numbers_, 2);
}

void FigureSheet::present(const FigureRow& row) {
  title_->setText(row.key.isEmpty() ? QString() : tr("Figure %1: %2").arg(row.key, row.title));
  caption_->setText(row.caption);
  const bool empty = !row.key.isEmpty() && row.problem.isEmpty() && row.left_out.isEmpty();
  picture_->setPicture(row.picture, empty ? tr("There is no picture.") : row.problem + row.left_out);
  picture_->setAccessibleName(row.key.isEmpty() ? tr("Picture") : title_->text());
  picture_->setAccessibleDescription(row.caption.isEmpty() ? tr("There is no picture.") : row.caption);
  showNumbers(row);
}

void FigureSheet::say(const QString& words) {
  picture_->setPicture({}, words);
}

bool FigureSheet::hasPicture() const {
  return picture_->hasPicture();
}

void FigureSheet::showNumbers(const FigureRow& row) {
  numbers_->setRowCount(0);
  numbers_->setVisible(!row.numbers.empty());  // a picture of the view has no numbers and takes their space
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

}  // namespace underact::gui
