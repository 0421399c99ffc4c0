#include "app/gui/gallery/gallery_dialog.h"

#include <QDesktopServices>
#include <QDir>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/gallery/figure_chooser.h"
#include "app/gui/gallery/figure_pdf.h"
#include "app/gui/gallery/figure_sheet.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/kit/words.h"
#include "underact/version.h"

namespace underact::gui {
namespace {

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
  return pushButton(QString("dialog.figures.") + name, text, tip, parent);
}

}  // namespace

GalleryDialog::GalleryDialog(GalleryCallbacks callbacks, const QString& only, QWidget* parent)
    : QDialog(parent),
      callbacks_(std::move(callbacks)),
      folder_(figureFolder()),
      only_(only),
      figures_(new FigureChooser(this)),
      sheet_(new FigureSheet(this)),
      message_(messageLabel("dialog.figures.message", tr("State of the figures"), "", this)),
      progress_(new QProgressBar(this)) {
  setObjectName("dialog.figures");
  setWindowTitle(tr("Figures of the thesis"));
  setModal(false);
  const QSize wanted(154 * fontMetrics().averageCharWidth(), 48 * fontMetrics().lineSpacing());
  resize(wanted.expandedTo({1080, 740}));
  sheet_->layout()->addWidget(buildActions());
  auto* parts = new QSplitter(Qt::Horizontal, this);
  parts->setChildrenCollapsible(false);
  parts->addWidget(figures_);
  parts->addWidget(sheet_);
  parts->setStretchFactor(1, 1);
  parts->setSizes({figures_->iconSize().width() + 32 * fontMetrics().averageCharWidth(), 700});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(parts, 1);
  column->addWidget(buildMaking());
  connect(figures_, &QListWidget::currentRowChanged, this, &GalleryDialog::showFigure);
  readFolder();
  figures_->setFocus();
}

QWidget* GalleryDialog::buildActions() {
  auto* strip = new QWidget(this);
  auto* row = tight<QHBoxLayout>(strip, 8);
  scene_ = button("scene", tr("&Open the scene"),
                  tr("Opens the figure's scene in the main window so that you can feel it."), strip);
  session_ = button("session", tr("Open the s&ession"), tr("Replays the run that the figure was drawn from."), strip);
  pdf_ = button("pdf", tr("Save as &PDF…"), tr("Saves the figure in print quality."), strip);
  for (QPushButton* one : {scene_, session_, pdf_}) row->addWidget(one);
  row->addStretch(1);
  connect(scene_, &QPushButton::clicked, this, [this] { callbacks_.open_scene(shown()->scene); });
  connect(session_, &QPushButton::clicked, this, [this] { callbacks_.open_session(shown()->session); });
  connect(pdf_, &QPushButton::clicked, this, &GalleryDialog::choosePdf);
  return strip;
}

QWidget* GalleryDialog::buildMaking() {
  auto* strip = new QWidget(this);
  progress_->setObjectName("dialog.figures.progress");
  progress_->setAccessibleName(tr("Progress"));
  progress_->hide();
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  make_ = button("make", tr("&Make the figures"),
                 tr("Runs every scene of the thesis again, draws the figures and checks their numbers."), strip);
  page_ = button("page", tr("Show the pa&ge"), tr("Opens a page with all figures in the browser."), strip);
  QPushButton* close =
      button("close", tr("&Close"), tr("Closes this window and cancels any figures still being made."), strip);
  row->addWidget(make_);
  row->addWidget(page_);
  row->addWidget(progress_, 1);
  row->addStretch(0);
  row->addWidget(close);
  auto* column = tight<QVBoxLayout>(strip, 8);
  column->addWidget(message_);
  column->addLayout(row);
  connect(make_, &QPushButton::clicked, this, &GalleryDialog::make);
  connect(page_, &QPushButton::clicked, this, [this] {
    const QString page = QDir(folder_).filePath("index.html");
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
      say(tr("The page could not be opened. Open it in a browser: %1").arg(page), "alarm");
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return strip;
}

GalleryDialog::~GalleryDialog() = default;

void GalleryDialog::setFolder(const QString& folder) {
  if (folder_ == folder) return;
  folder_ = folder;
  make_->setVisible(folder == figureFolder());
  readFolder();
}

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
  progress_->setRange(0, 0);  // Python is still starting
  progress_->show();
  make_->setText(tr("Ca&ncel"));
  make_->setAccessibleName(tr("Cancel"));
  say(
      tr("The figures are being made in the background, which takes about a minute. You can keep using the arm and the "
         "window."));
  run_->begin();
}

void GalleryDialog::ended(FiguresRun::End end, const QString& refusal) {
  run_.release()->deleteLater();  // it is the sender of this signal
  progress_->hide();
  readFolder();
  if (end != FiguresRun::End::Made) say(refusal, end == FiguresRun::End::Failed ? "alarm" : "");
}

void GalleryDialog::readFolder() {
  const Result<FigureList> read = readFigures(folder_);
  list_ = read ? read.value() : FigureList();
  make_->setText(read ? tr("&Make the figures again") : tr("&Make the figures"));
  make_->setAccessibleName(make_->text().remove('&'));
  make_->setDefault(!read);
  page_->setEnabled(static_cast<bool>(read));
  figures_->present(list_.rows);
  showFigure();
  if (!read) {
    say(sentencesOf(read.problems()));
    sheet_->say(
        tr("Underact runs each scene of the thesis with a scripted hand, draws the figures and checks their numbers. "
           "Press “Make the figures”; this takes about a minute."));
    return;
  }
  QString sentence = verdictOf(list_);
  const bool old = list_.program_version != kVersion;
  if (!list_.program_version.isEmpty())
    sentence +=
        ' ' + tr("Made by Underact %1 on %2.").arg(list_.program_version, list_.made.toString("yyyy-MM-dd hh:mm"));
  if (old) sentence += ' ' + tr("This is Underact %1; make the figures again to see its results.").arg(kVersion);
  const bool passed =
      std::all_of(list_.rows.begin(), list_.rows.end(), [](const FigureRow& row) { return row.passed; });
  say(sentence, !passed ? "alarm" : old ? "amber" : "");
}

void GalleryDialog::say(const QString& sentence, const char* role) {
  message_->setText(sentence);
  message_->setProperty("role", role);
  message_->setStyleSheet(message_->styleSheet());  // makes the style read the property again
}

const FigureRow* GalleryDialog::shown() const {
  const int index = figures_->currentRow();
  return index < 0 ? nullptr : &list_.rows[static_cast<std::size_t>(index)];
}

void GalleryDialog::showFigure() {
  const FigureRow none;
  const FigureRow& row = shown() == nullptr ? none : *shown();
  sheet_->present(row);
  scene_->setEnabled(!row.scene.isEmpty());
  session_->setVisible(callbacks_.open_session != nullptr);
  session_->setEnabled(!row.session.isEmpty());
  pdf_->setEnabled(sheet_->hasPicture());
}

void GalleryDialog::choosePdf() {
  const QString name = QString("figure_%1.pdf").arg(QString(shown()->key).replace('.', '_'));
  askWhereToSave(this, "dialog.figures.save", tr("Save the figure"), name, tr("PDF (*.pdf)"),
                 [this](const QString& path) { savePdf(path); });
}

void GalleryDialog::savePdf(const QString& path) {
  const FigureRow* row = shown();
  if (row == nullptr) return;
  const QString refusal = saveFigurePdf(*row, path);
  say(refusal.isEmpty() ? tr("Figure %1 was saved as %2").arg(row->key, path) : refusal,
      refusal.isEmpty() ? "" : "alarm");
}

}  // namespace underact::gui
