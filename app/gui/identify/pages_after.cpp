// The pages of the wizard after the measurement.
#include <QComboBox>
#include <QDate>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSaveFile>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/identify/pages.h"
#include "app/gui/identify/swing_plot.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_in_use.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

constexpr int kColumns = 6;

QString fromUtf8(const std::string& text) {
  return QString::fromStdString(text);
}

}  // namespace

FoundPage::FoundPage(IdentifyRun& run, QWidget* parent)
    : QWizardPage(parent),
      run_(run),
      what_(new QLabel(this)),
      table_(new QTableWidget(0, kColumns, this)),
      which_(new QComboBox(this)),
      plot_(new SwingPlot("identify.found.plot", this)) {
  setObjectName("identify.found");
  setTitle(tr("Results"));
  what_->setObjectName("identify.found.what");
  what_->setWordWrap(true);
  nameWidget(table_, "identify.table", tr("Results"));
  table_->setHorizontalHeaderLabels(
      {tr("quantity"), tr("value"), tr("uncertainty"), tr("unit"), tr("given"), tr("difference")});
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  which_->setObjectName("identify.which");
  nameChooser(which_, tr("Swings shown"), {});
  auto* column = new QVBoxLayout(this);
  column->addWidget(what_);
  column->addWidget(table_, 3);
  column->addWidget(which_);
  column->addWidget(plot_, 2);
  connect(which_, &QComboBox::currentIndexChanged, this, &FoundPage::showSwings);
}

void FoundPage::initializePage() {
  const identify::Given* const given = run_.given() ? &*run_.given() : nullptr;
  const std::vector<identify::ReportRow> rows = rowsOf(run_.found(), given);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const identify::ReportRow& one = rows[static_cast<std::size_t>(row)];
    const QString cells[kColumns] = {sentenceText(one.quantity),
                                     sentenceText(valueText(one)),
                                     sentenceText(uncertaintyText(one)),
                                     fromUtf8(one.unit),
                                     one.given ? localNumber(*one.given, 'g', 6) : QString(),
                                     sentenceText(differenceText(one))};
    for (int column = 0; column < kColumns; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      if (column != 0 && column != 3) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
  }
  table_->setColumnHidden(5, given == nullptr);
  QString text = tr("Uncertainty: one standard deviation. “below”: not distinguishable from zero.");
  if (given != nullptr) text += tr(" Given: the value of the simulated arm, or the stiffness that was commanded.");
  for (const Problem& note : run_.found().notes) text += QLatin1Char('\n') + sentenceText(note.sentence);
  what_->setText(text);
  which_->clear();
  for (const identify::AxisSwings& one : run_.found().swings)
    which_->addItem(tr("Swings along %1 at position %2, residual of the fit %3 µm")
                        .arg(QLatin1Char("xyz"[one.axis]))
                        .arg(one.place + 1)
                        .arg(numberText(1e6 * one.fit.residual_m, 1)));
}

void FoundPage::showSwings(int index) {
  if (index >= 0) plot_->present(pictureOf(run_.found().swings[static_cast<std::size_t>(index)]));
}

void FoundPage::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

KeepPage::KeepPage(IdentifyRun& run, const PlacePage& place, ArmInUse& in_use, QWidget* parent)
    : QWizardPage(parent),
      run_(run),
      place_(place),
      in_use_(in_use),
      name_(new QLineEdit(this)),
      title_(new QLineEdit(this)),
      provenance_(new QLabel(this)),
      told_(new QLabel(this)) {
  setObjectName("identify.keep");
  setTitle(tr("Save the results"));
  nameWidget(name_, "identify.name", tr("Name"), tr("A short name, shown in the status line."));
  nameWidget(title_, "identify.title", tr("Title"));
  nameWidget(provenance_, "identify.provenance", tr("Provenance"));
  nameWidget(told_, "identify.told", tr("Result of the last action"));
  for (QLabel* label : {provenance_, told_}) label->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Title"), title_);
  QPushButton* const save = button("identify.save", tr("&Save the arm…"),
                                   tr("Saves an arm file, for “Open a measured arm” and for the option --arm-model."));
  QPushButton* const report =
      button("identify.report", tr("Save the &report…"), tr("Saves the results as a Markdown file."));
  QPushButton* const use_it = button("identify.use", tr("&Use this arm"),
                                     tr("Gives the simulated arm these values, until you choose another arm."));
  use_it->setVisible(in_use.hasSimulatedArm());
  auto* column = new QVBoxLayout(this);
  column->setSpacing(12);
  column->addLayout(form);
  column->addWidget(provenance_);
  for (QPushButton* one : {save, report, use_it}) column->addWidget(one, 0, Qt::AlignLeft);
  column->addWidget(told_);
  column->addStretch(1);
  connect(save, &QPushButton::clicked, this, [this] {
    const QString path = chooseFile(tr("Save the arm"), ".json", tr("Arm models (*.json)"));
    if (!path.isEmpty()) saveModel(path);
  });
  connect(report, &QPushButton::clicked, this, [this] {
    const QString path = chooseFile(tr("Save the report"), ".md", tr("Markdown (*.md)"));
    if (!path.isEmpty()) saveReport(path);
  });
  connect(use_it, &QPushButton::clicked, this, &KeepPage::use);
}

QPushButton* KeepPage::button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QPushButton(text, this);
  nameWidget(made, name, QString(text).remove('&'), tip);
  return made;
}

void KeepPage::initializePage() {
  const QString date = QDate::currentDate().toString(Qt::ISODate);
  if (name_->text().isEmpty()) name_->setText(tr("measured-%1").arg(date));
  if (title_->text().isEmpty()) title_->setText(tr("%1, measured on %2").arg(place_.device(), date));
  provenance_->setText(fromUtf8(file().arm.provenance));
  told_->clear();
}

sim::ArmModelFile KeepPage::file() const {
  sim::Provenance provenance;
  provenance.device = place_.device().toStdString();
  provenance.serial = place_.serial().toStdString();
  provenance.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
  provenance.program = std::string("underact ") + kVersion;
  return modelFileOf(run_.found(), name_->text().toStdString(), title_->text().toStdString(), provenance);
}

bool KeepPage::write(const QString& path, const std::string& text) {
  QSaveFile out(path);
  const auto size = static_cast<qint64>(text.size());
  const bool written = out.open(QIODevice::WriteOnly) && out.write(text.data(), size) == size && out.commit();
  told_->setText(written ? tr("Saved as %1.").arg(path)
                         : tr("%1 could not be written: %2.").arg(path, out.errorString()));
  return written;
}

bool KeepPage::saveModel(const QString& path) {
  return write(path, armModelText(file()));
}

bool KeepPage::saveReport(const QString& path) {
  return write(path, reportText(run_.found(), file(), run_.given() ? &*run_.given() : nullptr));
}

bool KeepPage::use() {
  in_use_.use(file());
  told_->setText(tr("The simulated arm is now “%1”.").arg(title_->text()));
  return true;
}

QString KeepPage::chooseFile(const QString& what, const QString& suffix, const QString& filter) {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileDialog::getSaveFileName(this, what, folder + QLatin1Char('/') + name_->text() + suffix, filter);
}

}  // namespace underact::gui
