#include "app/gui/sessions/record_section.h"

#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/number_table.h"
#include "app/gui/kit/readout.h"
#include "app/gui/kit/section.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/session_words.h"
#include "app/gui/sessions/metadata_form.h"

namespace underact::gui {
namespace {

enum RecordRow { kTime, kSize, kTicks, kMarks, kDisk, kLasts };

}  // namespace

QString warningOf(const record::RecorderStatus& status, bool runs) {
  QStringList lines;
  if (status.files.size() > 1)
    lines << QObject::tr(
                 "The recording was split into %1 files, because a session's length is limited. The last one is %2.")
                 .arg(status.files.size())
                 .arg(QFileInfo(QString::fromStdString(status.files.back())).fileName());
  if (status.dropped > 0)
    lines << QObject::tr("%1 ticks are missing: the computer was too busy to write them. The servo kept running.")
                 .arg(status.dropped);
  if (runs && isDiskLow(status))
    lines
        << (status.disk_left_s > 0.0
                ? QObject::tr("The disk is nearly full: there is room for another %1. Free some space; otherwise the "
                              "recording stops and is saved.")
                      .arg(spanText(status.disk_left_s))
                : QObject::tr(
                      "The disk is nearly full: %1 left. Free some space; otherwise the recording stops and is saved.")
                      .arg(bytesText(status.disk_left_bytes)));
  return lines.join('\n');
}

RecordSection::RecordSection(Recording& recording, Actions& actions, QWidget* parent)
    : QWidget(parent),
      recording_(recording),
      actions_(actions),
      record_(new QPushButton(this)),
      mark_(new QPushButton(tr("&Mark"), this)),
      label_(new QLineEdit(this)),
      place_(quietLabel("panel.sessions.place", {}, this)),
      notice_(messageLabel("panel.sessions.notice", tr("Recording status"), "", this)),
      readout_(new Readout("panel.sessions.status", this)),
      words_(new MetadataForm("panel.sessions.", this)) {
  record_->setObjectName("panel.sessions.record");
  record_->setToolTip(actions_.find("session.record")->toolTip());
  readout_->addRow(tr("Time"), tr("From the first tick of the recording to the last."));
  readout_->addRow(tr("Size"), tr("Size of the file."));
  readout_->addRow(tr("Ticks"), tr("Ticks in the file, and ticks that could not be written, if any."));
  readout_->addRow(tr("Markers"), tr("Markers set with the M key, the button or the stylus."));
  readout_->addRow(tr("Free space"),
                   tr("Free space on the disk. The recording stops and is saved before the disk is full."));
  readout_->addRow(tr("Enough for"), tr("How long the free space lasts for this recording."));
  readout_->set(kTicks, tr("%1, %2 missing").arg(99'999'999).arg(9'999));
  auto* section =
      new Section("words", tr("Metadata"),
                  tr("Information about the session, saved in its file. You can edit it later."), this, "sessions");
  section->column().addWidget(words_);
  auto* column = tight<QVBoxLayout>(this, 4);
  column->addWidget(record_);
  column->addWidget(buildMark());
  column->addWidget(notice_);
  column->addWidget(readout_);
  column->addWidget(place_);
  column->addWidget(section);
  words_->setWords(recording_.words());
  connect(record_, &QPushButton::clicked, this, [this] { actions_.perform("session.record"); });
  connect(words_, &MetadataForm::edited, this, [this] {
    recording_.setWords(words_->words());
    if (recording_.words().consent.empty()) words_->clearConsent();
  });
  connect(&recording_, &Recording::changed, this, &RecordSection::present);
}

QWidget* RecordSection::buildMark() {
  auto* strip = new QWidget(this);
  auto* row = tight<QHBoxLayout>(strip, 4);
  mark_->setObjectName("panel.sessions.mark");
  mark_->setAccessibleName(tr("Set a marker"));
  mark_->setToolTip(actions_.find("session.mark")->toolTip());
  label_->setObjectName("panel.sessions.mark_label");
  label_->setAccessibleName(tr("Label of the next marker"));
  label_->setToolTip(tr("Label of the next marker. Press Enter to set it."));
  label_->setPlaceholderText(tr("Label"));
  row->addWidget(label_, 1);
  row->addWidget(mark_);
  connect(mark_, &QPushButton::clicked, this, [this] { actions_.perform("session.mark"); });
  connect(label_, &QLineEdit::returnPressed, this, [this] { actions_.perform("session.mark"); });
  return strip;
}

QString RecordSection::takeLabel() {
  QString label = label_->text();
  label_->clear();
  return label;
}

void RecordSection::present() {
  const bool runs = recording_.isRunning();
  const record::RecorderStatus& status = recording_.status();
  record_->setText(runs ? tr("Stop &recording") : tr("&Record"));
  record_->setAccessibleName(runs ? tr("Stop recording") : tr("Record"));
  mark_->setEnabled(runs);
  if (was_running_ && !runs) words_->setWords(recording_.words());  // the metadata of the last session were cleared
  was_running_ = runs;
  const bool any = runs || !recording_.path().isEmpty();
  readout_->setVisible(any);
  place_->setVisible(any);
  const QString warning = warningOf(status, runs);
  const bool alarming = !runs && !recording_.notice().isEmpty();
  const QString given = alarming ? recording_.notice() : warning;
  showMessage(notice_, given);
  const char* role = alarming ? "alarm" : "amber";
  if (notice_->property("role") != role) {
    notice_->setProperty("role", role);
    notice_->style()->polish(notice_);
  }
  if (!any) return;
  readout_->set(kTime, clockText(status.duration_s));
  readout_->set(kSize, bytesText(status.bytes));
  readout_->set(kTicks, status.dropped == 0 ? QString::number(status.ticks)
                                            : tr("%1, %2 missing").arg(status.ticks).arg(status.dropped));
  readout_->set(kMarks, QString::number(recording_.marks()));
  readout_->set(kDisk, status.disk_left_bytes > 0 ? bytesText(status.disk_left_bytes) : QChar(0x2013));
  readout_->set(kLasts, status.disk_left_s > 0.0 ? spanText(status.disk_left_s) : QChar(0x2013));
  const QString file = QFileInfo(recording_.path()).fileName().replace('_', QString("_") + QChar(0x200B));  // may break
  place_->setText(runs ? tr("Recording to %1").arg(file) : tr("Saved as %1").arg(file));
  place_->setToolTip(recording_.path());
}

}  // namespace underact::gui
