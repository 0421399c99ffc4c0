#include "app/gui/kit/readout.h"

#include <QGridLayout>
#include <QLabel>

#include "app/gui/kit/message_label.h"

namespace underact::gui {

Readout::Readout(const QString& object_name, QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  setObjectName(object_name);
  grid_->setContentsMargins(12, 8, 12, 8);
  grid_->setHorizontalSpacing(12);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 1);
}

void Readout::addHeading(const QString& text) {
  QLabel* heading = sectionTitle(text, this);
  grid_->addWidget(heading, lines_++, 0, 1, 2);
}

int Readout::addRow(const QString& label, const QString& tip) {
  const auto row = static_cast<int>(values_.size());
  auto* left = new QLabel(label, this);
  left->setProperty("role", "quiet");
  left->setToolTip(tip);
  auto* right = new QLabel(this);
  nameWidget(right, QString("%1.%2").arg(objectName()).arg(row), label);
  right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  right->setToolTip(tip);
  right->setTextInteractionFlags(Qt::TextSelectableByMouse);
  grid_->addWidget(left, lines_, 0);
  grid_->addWidget(right, lines_++, 1);
  labels_.push_back(left);
  values_.push_back(right);
  return row;
}

void Readout::set(int row, const QString& value) {
  QLabel* label = values_[static_cast<std::size_t>(row)];
  if (label->text() != value) label->setText(value);  // even an equal text would trigger a new layout
}

QString Readout::value(int row) const {
  return values_[static_cast<std::size_t>(row)]->text();
}

void Readout::clear() {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  labels_.clear();
  values_.clear();
  lines_ = 0;
}

}  // namespace underact::gui
