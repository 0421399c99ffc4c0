#include "app/gui/kit/number_table.h"

#include <QGridLayout>

#include "app/gui/kit/message_label.h"

namespace underact::gui {

NumberTable::NumberTable(const QString& object_name, std::vector<Column> columns, QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)), columns_(std::move(columns)) {
  setObjectName(object_name);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(4);
  grid_->setVerticalSpacing(2);
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    auto* head = new QLabel(columns_[column].head, this);
    head->setProperty("role", "quiet");
    head->setAlignment(columns_[column].words ? Qt::AlignLeft : Qt::AlignRight);
    grid_->addWidget(head, 0, static_cast<int>(column) + 1);
    heads_.push_back(head);
  }
  grid_->setColumnStretch(static_cast<int>(columns_.size()) + 1, 1);
}

void NumberTable::addRow(const QString& head, const QString& tip) {
  const auto row = static_cast<int>(cells_.size()) + 1;
  auto* left = new QLabel(head, this);
  left->setProperty("role", "quiet");
  left->setToolTip(tip);
  grid_->addWidget(left, row, 0);
  lefts_.push_back(left);
  std::vector<QLabel*> cells;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    auto* cell = new QLabel(this);
    const auto number = static_cast<int>(column) + 1;
    nameWidget(cell, QString("%1.%2.%3").arg(objectName()).arg(row).arg(number),
               QString("%1 %2").arg(head, columns_[column].head));
    cell->setAlignment((columns_[column].words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    cell->setFixedSize(fontMetrics().horizontalAdvance(columns_[column].widest) + 4, fontMetrics().lineSpacing());
    cell->setToolTip(tip);
    cell->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid_->addWidget(cell, row, number);
    cells.push_back(cell);
  }
  cells_.push_back(std::move(cells));
}

void NumberTable::set(int row, int column, const QString& text) {
  QLabel* cell = cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
  if (cell->text() != text) cell->setText(text);
}

QString NumberTable::text(int row, int column) const {
  return cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]->text();
}

void NumberTable::showOnly(int rows, int columns) {
  for (std::size_t column = 0; column < heads_.size(); ++column)
    heads_[column]->setVisible(static_cast<int>(column) < columns);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const bool shown = static_cast<int>(row) < rows;
    lefts_[row]->setVisible(shown);
    for (std::size_t column = 0; column < cells_[row].size(); ++column)
      cells_[row][column]->setVisible(shown && static_cast<int>(column) < columns);
  }
}

QLabel* quietLabel(const QString& object_name, const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(object_name);
  label->setProperty("role", "quiet");
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace underact::gui
