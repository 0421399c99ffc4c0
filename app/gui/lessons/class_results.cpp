#include "app/gui/lessons/class_results.h"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSaveFile>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/kit/chooser.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tab_order.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "core/base/printed.h"

namespace underact::gui {
namespace {

constexpr int kColumnGap = 12;         // between columns
constexpr qsizetype kShownUnread = 4;  // files that are named below the table; of all there is the number

/// A cell that is sorted by a number, or by its text as the language has it.
class Cell : public QTableWidgetItem {
 public:
  explicit Cell(const std::string& text) : QTableWidgetItem(QString::fromStdString(printed(text))) {}
  Cell(const QString& text, double order) : QTableWidgetItem(text), order_(order) {}
  bool operator<(const QTableWidgetItem& other) const override {
    const auto& cell = static_cast<const Cell&>(other);
    return order_ != cell.order_ ? order_ < cell.order_ : text().localeAwareCompare(cell.text()) < 0;
  }

 private:
  double order_ = 0.0;
};

/// "%1 of %2" by its share.
Cell* solvedCell(const lesson::ResultRow& row) {
  const auto all = static_cast<double>(row.steps), solved = static_cast<double>(row.solved);
  return new Cell(ClassResults::tr("%1 of %2").arg(row.solved).arg(row.steps), solved / all);
}

Cell* stepCell(const lesson::ResultRow& row) {
  if (row.stopped_at == 0) return new Cell(ClassResults::tr("– all solved"), lesson::kMaxReports);
  return new Cell(QString("%1. %2").arg(row.stopped_at).arg(QString::fromStdString(printed(row.stopped_title))),
                  static_cast<double>(row.stopped_at));
}

Cell* dateCell(const std::string& date) {
  const QDateTime when = QDateTime::fromString(QString::fromStdString(date), Qt::ISODate);
  if (!when.isValid()) return new Cell(date);
  return new Cell(QLocale().toString(when, QLocale::ShortFormat), static_cast<double>(when.toSecsSinceEpoch()));
}

}  // namespace

ClassResults::ClassResults(QWidget* parent)
    : QDialog(parent),
      message_(messageLabel("dialog.class_results.message", tr("Folder"), "", this)),
      unread_(messageLabel("dialog.class_results.unread", tr("Files that are not in the table"), "amber", this)),
      order_(new QComboBox(this)),
      table_(new QTableWidget(this)) {
  setObjectName("dialog.class_results");
  setWindowTitle(tr("Class results"));
  setModal(false);
  resize(QSize(150 * fontMetrics().averageCharWidth(), 34 * fontMetrics().lineSpacing()).expandedTo({1160, 600}));
  const QStringList columns{tr("Student"),    tr("Lesson"),        tr("Date"),          tr("Solved"),
                            tr("Stopped at"), tr("Wrong answers"), tr("Misconception"), tr("Report")};
  nameWidget(table_, "dialog.class_results.table", tr("Class results"));
  table_->setColumnCount(static_cast<int>(columns.size()));
  table_->setHorizontalHeaderLabels(columns);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setSortIndicator(0, Qt::AscendingOrder);
  table_->verticalHeader()->hide();
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setWordWrap(false);
  order_->setObjectName("dialog.class_results.order");
  nameChooser(order_, tr("Sort by"), tr("The column that the table is sorted by."));
  order_->addItems(columns);
  connect(order_, &QComboBox::currentIndexChanged, this, &ClassResults::sort);
  connect(table_->horizontalHeader(), &QHeaderView::sortIndicatorChanged, order_, &QComboBox::setCurrentIndex);
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(message_);
  column->addWidget(table_, 1);
  column->addWidget(unread_);
  column->addWidget(buildButtons());
  orderTabs({this});
  fillTable();
}

QWidget* ClassResults::buildButtons() {
  auto* const strip = new QWidget(this);
  auto* const row = tight<QHBoxLayout>(strip, 8);
  const auto add = [&](const char* name, const QString& text, const QString& tip, auto&& run) {
    QPushButton* const button = pushButton(QString("dialog.class_results.") + name, text, tip, strip);
    connect(button, &QPushButton::clicked, this, run);
    row->addWidget(button);
    return button;
  };
  add("open", tr("&Open folder…"), tr("Reads the reports in a folder and in its folders."), [this] { chooseFolder(); });
  csv_ = add("csv", tr("&Save as CSV…"), tr("Saves the table for a spreadsheet."), [this] { chooseFile(false); });
  moodle_ = add("moodle", tr("Save for &Moodle…"),
                tr("Saves the steps solved, in percent, as the CSV that Moodle imports as grades."),
                [this] { chooseFile(true); });
  row->addStretch(1);
  auto* const sort_by = new QLabel(tr("Sor&t by"), strip);
  sort_by->setBuddy(order_);
  row->addWidget(sort_by);
  row->addWidget(order_);
  add("close", tr("&Close"), tr("Closes this window."), [this] { reject(); });
  return strip;
}

void ClassResults::read(const QString& folder) {
  Result<lesson::ClassResults> read = lesson::readResults(folder.toStdString());
  if (!read) return say(sentencesOf(read.problems()), true);
  folder_ = folder;
  results_ = std::move(read).value();
  fillTable();
}

void ClassResults::fillTable() {
  const auto rows = static_cast<int>(results_.rows.size());
  table_->setSortingEnabled(false);
  table_->setRowCount(rows);
  for (int at = 0; at < rows; ++at) {
    const lesson::ResultRow& row = results_.rows[static_cast<std::size_t>(at)];
    int column = 0;
    for (Cell* const cell : {row.student.empty() ? new Cell(tr("(no name)"), 1.0) : new Cell(row.student),
                             new Cell(row.title), dateCell(row.date), solvedCell(row), stepCell(row),
                             new Cell(QString::number(row.wrong), static_cast<double>(row.wrong)),
                             new Cell(row.misconception), new Cell(row.report)})
      table_->setItem(at, column++, cell);
  }
  table_->resizeColumnsToContents();
  for (int at = 0; at < table_->columnCount(); ++at) table_->setColumnWidth(at, table_->columnWidth(at) + kColumnGap);
  table_->setSortingEnabled(true);
  sort(order_->currentIndex());
  for (QPushButton* const button : {csv_, moodle_}) button->setEnabled(rows > 0);
  order_->setEnabled(rows > 0);
  if (folder_.isEmpty())
    say(tr(
        "Choose the folder with the reports that your students saved (Lessons, Save report). Each student and lesson "
        "becomes a row."));
  else
    say(rows > 0 ? tr("Reports in %1: %2").arg(QDir(folder_).dirName(), QString::number(rows))
                 : tr("There are no reports in %1. Students save one with Lessons, Save report.")
                       .arg(QDir::toNativeSeparators(folder_)));
  QStringList lines;
  for (const Problems& list : {results_.unread, results_.older})
    for (const Problem& problem : list)
      lines << QString("%1: %2").arg(QFileInfo(QString::fromStdString(printed(problem.place.file))).fileName(),
                                     sentenceText(problem.sentence));
  const qsizetype more = lines.size() - kShownUnread;
  if (more > 0) lines = lines.mid(0, kShownUnread) << tr("And %n more.", nullptr, static_cast<int>(more));
  showMessage(unread_, lines.join('\n'));
}

void ClassResults::sort(int column) {
  const QSignalBlocker silent(order_);  // the head of the table tells it
  table_->sortByColumn(column, table_->horizontalHeader()->sortIndicatorOrder());
}

void ClassResults::say(const QString& sentence, bool is_wrong) {
  message_->setText(sentence);
  message_->setToolTip(QDir::toNativeSeparators(folder_));
  message_->setProperty("role", is_wrong ? "alarm" : "");
  message_->setStyleSheet(message_->styleSheet());  // makes the style read the property again
}

void ClassResults::chooseFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  askForFolder(this, "dialog.class_results_folder", tr("Open a folder of reports"),
               folder_.isEmpty() ? documents : folder_, [this](const QString& folder) { read(folder); });
}

void ClassResults::chooseFile(bool for_moodle) {
  const QString name = fileNameOf(QFileInfo(folder_).fileName()) + (for_moodle ? "-moodle.csv" : "-results.csv");
  askWhereToSave(this, "dialog.class_results_save", for_moodle ? tr("Save for Moodle") : tr("Save as CSV"), name,
                 tr("CSV (*.csv)"), [this, for_moodle](const QString& path) { save(path, for_moodle); });
}

bool ClassResults::save(const QString& path, bool for_moodle) {
  const std::string text = for_moodle ? moodleCsv(results_) : resultsCsv(results_);
  QSaveFile file(path);  // the whole file or nothing
  const bool saved = file.open(QIODevice::WriteOnly) &&
                     file.write(text.data(), static_cast<qint64>(text.size())) >= 0 && file.commit();
  QString sentence = saved ? tr("Saved as %1.").arg(QDir::toNativeSeparators(path))
                           : tr("Not saved: %1. Choose another folder.").arg(file.errorString());
  const std::size_t nameless = withoutName(results_);
  if (saved && for_moodle && nameless > 0) sentence += ' ' + tr("Left out, as they have no name: %1.").arg(nameless);
  say(sentence, !saved);
  return saved;
}

void showClassResults(QWidget* window, const QString& folder) {
  auto* dialog = window->findChild<ClassResults*>();
  if (dialog == nullptr) {
    dialog = new ClassResults(window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  if (!folder.isEmpty()) dialog->read(folder);
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

}  // namespace underact::gui
