#include "app/gui/fault/fault_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyle>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/plot/fault_plot.h"

namespace underact::gui {
namespace {

constexpr std::size_t kMaxTold = record::kFaultFilesKept;  // files of older faults are deleted, too

}  // namespace

FaultDialog::FaultDialog(QWidget* parent)
    : QDialog(parent),
      list_(new QListWidget(this)),
      what_(messageLabel("dialog.fault.what", tr("What happened"), "", this)),
      meaning_(messageLabel("dialog.fault.meaning", tr("What it means"), "", this)),
      to_do_(messageLabel("dialog.fault.to_do", tr("What to do"), "", this)),
      file_(messageLabel("dialog.fault.file", tr("Fault file"), "", this)),
      plot_(new FaultPlot(this)) {
  setObjectName("dialog.fault");
  setModal(false);
  setAttribute(Qt::WA_ShowWithoutActivating);
  setWindowTitle(tr("The servo has stopped"));
  resize(600, 460);
  nameWidget(list_, "dialog.fault.list", tr("Faults"));
  list_->setMaximumHeight(5 * fontMetrics().lineSpacing());
  list_->setTabKeyNavigation(false);
  what_->setProperty("role", "alarm");
  file_->setProperty("role", "quiet");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(8);
  column->addWidget(list_);
  column->addWidget(what_);
  column->addWidget(meaning_);
  column->addWidget(to_do_);
  column->addWidget(plot_, 1);
  column->addWidget(file_);
  column->addWidget(buildButtons());
  connect(list_, &QListWidget::currentRowChanged, this, &FaultDialog::showFault);
}

QWidget* FaultDialog::buildButtons() {
  auto* strip = new QWidget(this);
  auto* row = new QHBoxLayout(strip);
  row->setContentsMargins(0, 4, 0, 0);
  row->setSpacing(8);
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    QPushButton* made = pushButton(QString("dialog.fault.") + name, text, tip, strip);
    row->addWidget(made);
    return made;
  };
  start_ = button("start", tr("&Start again"), tr("Turns the force on again, with a soft start."));
  QPushButton* restart =
      button("restart", tr("&Restart the servo"), tr("Reopens the arm and restarts the servo. Then press Start."));
  row->addStretch(1);
  folder_ = button("folder", tr("Show &folder"), tr("Opens the folder that holds the file."));
  copy_ = button("copy", tr("Copy &path"), tr("Copies the path of the file."));
  QPushButton* close =
      button("close", tr("&Close"), tr("Closes this message. The servo stays stopped until you press Start."));
  connect(start_, &QPushButton::clicked, this, &FaultDialog::startAsked);
  connect(restart, &QPushButton::clicked, this, &FaultDialog::restartAsked);
  connect(folder_, &QPushButton::clicked, this, [this] {
    const QString path = faults_[static_cast<std::size_t>(shown_)].path;
    QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath()));
  });
  connect(copy_, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(faults_[static_cast<std::size_t>(shown_)].path); });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return strip;
}

void FaultDialog::tell(const ShownFault& fault) {
  if (faults_.size() >= kMaxTold) faults_.erase(faults_.begin());
  faults_.push_back(fault);
  fillList();
  showFault(count() - 1);
  show();
  raise();
}

void FaultDialog::tellAgain() {
  if (faults_.empty()) return;
  ++faults_.back().times;
  fillList();
  showFault(count() - 1);
}

void FaultDialog::fillList() {
  const QSignalBlocker silent(list_);
  list_->clear();
  for (const ShownFault& fault : faults_) {
    list_->addItem(QString("%1  %2").arg(fault.when, sentenceText(fault.words.what)));
  }
  list_->setCurrentRow(count() - 1);
  list_->setVisible(count() > 1);
}

void FaultDialog::showFault(int index) {
  if (index < 0 || index >= count()) return;
  shown_ = index;
  const ShownFault& fault = faults_[static_cast<std::size_t>(index)];
  const QString what = sentenceText(fault.words.what);
  what_->setText(fault.times > 1 ? tr("%1 (%2 times)").arg(what).arg(fault.times) : what);
  meaning_->setText(tr("Force is off and stays off until you press Start."));
  to_do_->setText(sentenceText(fault.words.what_to_do));
  const bool kept = !fault.path.isEmpty();
  file_->setText(kept ? tr("The last second before the fault is saved in %1").arg(fault.path) : fault.not_kept);
  file_->setProperty("role", kept ? "quiet" : "alarm");
  file_->style()->polish(file_);
  folder_->setEnabled(kept);
  copy_->setEnabled(kept);
  plot_->setTicks(fault.last_second, fault.rate_hz);
}

void FaultDialog::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void FaultDialog::setStartable(bool can_start) {
  start_->setEnabled(can_start);
}

void FaultDialog::hideEvent(QHideEvent* event) {
  QDialog::hideEvent(event);
  if (!event->spontaneous()) faults_.clear();  // read and closed; the files remain
}

}  // namespace underact::gui
