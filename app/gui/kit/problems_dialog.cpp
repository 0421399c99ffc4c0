#include "app/gui/kit/problems_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"

namespace underact::gui {
namespace {

QString placeNumber(int number) {
  return number > 0 ? QString::number(number) : QString();
}

constexpr const char* kOfFile = "saysWhatIsWrongWithAFile";

}  // namespace

ProblemsDialog::ProblemsDialog(QWidget* parent)
    : QDialog(parent), heading_(new QLabel(this)), table_(new QTableWidget(this)) {
  setObjectName("dialog.problems");
  setProperty(kOfFile, true);
  setModal(false);  // a broken file must not block access to the arm
  setWindowTitle(tr("Scene not opened"));
  resize(720, 360);
  nameWidget(heading_, "dialog.problems.heading", tr("What happened"));
  heading_->setWordWrap(true);
  nameWidget(table_, "dialog.problems.table", tr("Problems in the file"));
  table_->setColumnCount(4);
  table_->setHorizontalHeaderLabels({tr("Line"), tr("Column"), tr("Key"), tr("Problem")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->setWordWrap(true);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  // Not in a QDialogButtonBox: with that of Qt 6.8, Tab skips the first two.
  QPushButton* copy = pushButton("dialog.problems.copy", tr("&Copy"), {}, this, tr("Copy the problems"));
  QPushButton* another =
      pushButton("dialog.problems.another", tr("&Open another…"), {}, this, tr("Open another scene file"));
  QPushButton* close = pushButton("dialog.problems.close", tr("Close"), {}, this);
  for (QPushButton* button : {copy, another, close}) button->setAutoDefault(true);  // Enter presses the focused one
  close->setDefault(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(heading_);
  column->addWidget(table_, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copy);
  buttons->addWidget(another);
  buttons->addStretch();
  buttons->addWidget(close);
  column->addLayout(buttons);
  connect(copy, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
  connect(another, &QPushButton::clicked, this, [this] {
    hide();
    emit openAnother();
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void ProblemsDialog::show(const QString& path, const Problems& problems) {
  problems_ = problems;
  const QString count = problems.size() == 1 ? tr("One problem") : tr("%1 problems").arg(problems.size());
  heading_->setText(
      tr("%1 was not opened; your previous scene stays open. %2 to fix:").arg(QFileInfo(path).fileName(), count));
  table_->setRowCount(static_cast<int>(problems.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const Problem& problem = problems[static_cast<std::size_t>(row)];
    const QStringList cells{placeNumber(problem.place.line), placeNumber(problem.place.column),
                            QString::fromStdString(problem.place.key), sentenceText(problem.sentence)};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(cells[column]);
      table_->setItem(row, column, item);
    }
  }
  QDialog::show();
  table_->resizeRowsToContents();
  raise();
  activateWindow();
}

QString ProblemsDialog::text() const {
  QStringList lines;
  for (const Problem& problem : problems_) {
    const Problem shown{sentenceText(problem.sentence).toStdString(), problem.place};
    lines << QString::fromStdString(describe(shown));
  }
  return lines.join('\n');
}

void showProblemsBox(const QString& name, const QString& title, const QString& what, const Problems& problems,
                     QWidget* window) {
  QStringList sentences;
  for (const Problem& problem : problems) {
    const QString sentence = sentenceText(problem.sentence);
    sentences << (problem.place.line > 0 ? QObject::tr("Line %1: %2").arg(problem.place.line).arg(sentence) : sentence);
  }
  auto* box = new QMessageBox(QMessageBox::Warning, title, what, QMessageBox::Ok, window);
  box->setObjectName(name);
  box->setProperty(kOfFile, name.endsWith("_problems"));
  box->setInformativeText(sentences.join("\n"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->show();
}

void closeProblems() {
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget->isVisible() && widget->property(kOfFile).toBool()) widget->close();
  }
}

}  // namespace underact::gui
