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

#include "app/gui/identify/identify_wizard.h"
#include "app/gui/identify/swing_plot.h"
#include "app/gui/kit/chooser.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/arm_in_use.h"
#include "underact/version.h"

namespace underact::gui {

ProcedurePage* IdentifyWizard::foundPage() {
  auto* page = new ProcedurePage("identify.found", tr("Results"), -1);
  what_ = page->addText("identify.found.what");
  table_ = page->table("identify.table", tr("Results"),
                       {tr("quantity"), tr("value"), tr("uncertainty"), tr("unit"), tr("given"), tr("difference")});
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  which_ = new QComboBox(page);
  which_->setObjectName("identify.which");
  nameChooser(which_, tr("Swings shown"), {});
  auto* plot = inTheme(theme_, new SwingPlot("identify.found.plot", page));
  page->column()->addWidget(table_, 3);
  page->column()->addWidget(which_);
  page->column()->addWidget(plot, 2);
  page->enter = [this] { showResults(); };
  connect(which_, &QComboBox::currentIndexChanged, this, [this, plot](int index) {
    if (index >= 0) plot->present(pictureOf(run_.found().swings[static_cast<std::size_t>(index)]));
  });
  return page;
}

void IdentifyWizard::showResults() {
  const identify::Given* const given = run_.given() ? &*run_.given() : nullptr;
  const std::vector<identify::ReportRow> rows = rowsOf(run_.found(), given);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const identify::ReportRow& one = rows[static_cast<std::size_t>(row)];
    setRow(table_, row,
           {sentenceText(one.quantity), sentenceText(valueText(one)), sentenceText(uncertaintyText(one)),
            QString::fromStdString(one.unit), one.given ? localNumber(*one.given, 'g', 6) : QString(),
            sentenceText(differenceText(one))});
    for (const int column : {1, 2, 4, 5})
      table_->item(row, column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
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

ProcedurePage* IdentifyWizard::keepPage() {
  keep_ = new ProcedurePage("identify.keep", tr("Save the results"), 12);
  name_ = new QLineEdit(keep_);
  title_ = new QLineEdit(keep_);
  nameWidget(name_, "identify.name", tr("Name"), tr("A short name, shown in the status line."));
  nameWidget(title_, "identify.title", tr("Title"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Name"), name_);
  form->addRow(tr("&Title"), title_);
  keep_->column()->addLayout(form);
  provenance_ = keep_->addText("identify.provenance");
  provenance_->setAccessibleName(tr("Provenance"));
  const auto save = keep_->button("identify.save", tr("&Save the arm…"),
                                  tr("Saves an arm file, for “Open a measured arm” and for the option --arm-model."));
  const auto report =
      keep_->button("identify.report", tr("Save the &report…"), tr("Saves the results as a Markdown file."));
  const auto use = keep_->button("identify.use", tr("&Use this arm"),
                                 tr("Gives the simulated arm these values, until you choose another arm."));
  use->setVisible(parts_.in_use.hasSimulatedArm());
  for (QPushButton* one : {save, report, use}) keep_->column()->addWidget(one, 0, Qt::AlignLeft);
  told_ = keep_->addText("identify.told");
  told_->setAccessibleName(tr("Result of the last action"));
  keep_->column()->addStretch(1);
  keep_->enter = [this] { showKept(); };
  connect(save, &QPushButton::clicked, this, [this] {
    const QString path = chooseFile(tr("Save the arm"), ".json", tr("Arm models (*.json)"));
    if (!path.isEmpty()) saveModel(path);
  });
  connect(report, &QPushButton::clicked, this, [this] {
    const QString path = chooseFile(tr("Save the report"), ".md", tr("Markdown (*.md)"));
    if (!path.isEmpty()) saveReport(path);
  });
  connect(use, &QPushButton::clicked, this, [this] {
    parts_.in_use.use(file());
    told_->setText(tr("The simulated arm is now “%1”.").arg(title_->text()));
  });
  return keep_;
}

void IdentifyWizard::showKept() {
  const QString date = QDate::currentDate().toString(Qt::ISODate);
  if (name_->text().isEmpty()) name_->setText(tr("measured-%1").arg(date));
  if (title_->text().isEmpty()) title_->setText(tr("%1, measured on %2").arg(device_->text(), date));
  provenance_->setText(QString::fromStdString(file().arm.provenance));
  told_->clear();
}

sim::ArmModelFile IdentifyWizard::file() const {
  sim::Provenance provenance;
  provenance.device = device_->text().toStdString();
  provenance.serial = serial_->text().toStdString();
  provenance.date = QDate::currentDate().toString(Qt::ISODate).toStdString();
  provenance.program = std::string("underact ") + kVersion;
  return modelFileOf(run_.found(), name_->text().toStdString(), title_->text().toStdString(), provenance);
}

bool IdentifyWizard::write(const QString& path, const std::string& text) {
  QSaveFile out(path);
  const auto size = static_cast<qint64>(text.size());
  const bool written = out.open(QIODevice::WriteOnly) && out.write(text.data(), size) == size && out.commit();
  told_->setText(written ? tr("Saved as %1.").arg(path)
                         : tr("%1 could not be written: %2.").arg(path, out.errorString()));
  return written;
}

bool IdentifyWizard::saveModel(const QString& path) {
  return hasResult() && write(path, armModelText(file()));
}

bool IdentifyWizard::saveReport(const QString& path) {
  return hasResult() && write(path, reportText(run_.found(), file(), run_.given() ? &*run_.given() : nullptr));
}

QString IdentifyWizard::chooseFile(const QString& what, const QString& suffix, const QString& filter) {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileDialog::getSaveFileName(this, what, folder + QLatin1Char('/') + name_->text() + suffix, filter);
}

}  // namespace underact::gui
