// How the gallery is put together; what it does is in gallery_dialog.cpp.
#include <QDesktopServices>
#include <QDir>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSplitter>
#include <QTableWidget>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/gallery/figure_picture.h"
#include "app/gui/gallery/gallery_dialog.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/told_label.h"

namespace underact::gui {
namespace {

constexpr QSize kThumbnail(112, 80);

}  // namespace

GalleryDialog::GalleryDialog(GalleryWays ways, const QString& only, QWidget* parent)
    : QDialog(parent),
      ways_(std::move(ways)),
      folder_(figureFolder()),
      only_(only),
      figures_(new QListWidget(this)),
      title_(toldLabel("dialog.figures.title", tr("Figure"), "section", this)),
      caption_(toldLabel("dialog.figures.caption", tr("Caption"), "", this)),
      message_(toldLabel("dialog.figures.message", tr("State of the figures"), "", this)),
      picture_(new FigurePicture(this)),
      numbers_(new QTableWidget(0, 6, this)),
      progress_(new QProgressBar(this)),
      thumbnails_(new QTimer(this)) {
  setObjectName("dialog.figures");
  setWindowTitle(tr("Figures of the thesis"));
  setModal(false);
  const QSize wished(154 * fontMetrics().averageCharWidth(), 48 * fontMetrics().lineSpacing());
  resize(wished.expandedTo({1080, 740}).boundedTo(screen()->availableSize()));
  figures_->setObjectName("dialog.figures.list");
  figures_->setAccessibleName(tr("Figures"));
  figures_->setIconSize(kThumbnail);
  figures_->setWordWrap(true);
  figures_->setResizeMode(QListView::Adjust);
  figures_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  figures_->setSpacing(2);
  figures_->setStyleSheet("QListWidget { show-decoration-selected: 1; }");  // the whole row, with its picture
  figures_->setMinimumWidth(kThumbnail.width() + 12 * fontMetrics().averageCharWidth());
  auto* parts = new QSplitter(Qt::Horizontal, this);
  parts->setChildrenCollapsible(false);
  parts->addWidget(figures_);
  parts->addWidget(buildShown());
  parts->setStretchFactor(1, 1);
  parts->setSizes({kThumbnail.width() + 32 * fontMetrics().averageCharWidth(), 700});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(parts, 1);
  column->addWidget(buildMaking());
  connect(figures_, &QListWidget::currentRowChanged, this, &GalleryDialog::showFigure);
  connect(thumbnails_, &QTimer::timeout, this, &GalleryDialog::addNextThumbnail);
  readFolder();
  figures_->setFocus();
}

QWidget* GalleryDialog::buildShown() {
  auto* side = new QWidget(this);
  picture_->setObjectName("dialog.figures.picture");
  numbers_->setObjectName("dialog.figures.numbers");
  numbers_->setAccessibleName(tr("Numbers that the figure must show"));
  numbers_->setHorizontalHeaderLabels(
      {tr("Number"), tr("Measured"), tr("Expected"), tr("Within"), tr("Unit"), tr("Result")});
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
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(12, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(picture_, 3);
  column->addWidget(caption_);
  column->addWidget(numbers_, 2);
  column->addWidget(buildActions());
  return side;
}

QWidget* GalleryDialog::buildActions() {
  auto* strip = new QWidget(this);
  auto* row = new QHBoxLayout(strip);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  scene_ = button("scene", tr("&Open the scene"), tr("Opens the figure's scene in the window, to be felt."), strip);
  session_ = button("session", tr("Open the s&ession"), tr("Replays the run that the figure was drawn from."), strip);
  pdf_ = button("pdf", tr("Save as &PDF…"), tr("Keeps the figure as it was drawn for print."), strip);
  row->addStretch(1);
  connect(scene_, &QPushButton::clicked, this, [this] { ways_.open_scene(shown()->scene); });
  connect(session_, &QPushButton::clicked, this, [this] { ways_.open_session(shown()->session); });
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
  make_ = button("make", tr("&Make the figures"), tr("Runs every scene of the thesis anew, draws and checks."), strip);
  page_ = button("page", tr("Show the pa&ge"), tr("Opens all figures as one page in the browser."), strip);
  QPushButton* close = button("close", tr("&Close"), tr("Closes this. A making that goes on is ended."), strip);
  row->addWidget(make_);
  row->addWidget(page_);
  row->addWidget(progress_, 1);
  row->addStretch(0);
  row->addWidget(close);
  auto* column = new QVBoxLayout(strip);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(message_);
  column->addLayout(row);
  connect(make_, &QPushButton::clicked, this, &GalleryDialog::make);
  connect(page_, &QPushButton::clicked, this, [this] {
    const QString page = QDir(folder_).filePath("index.html");
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
      say(tr("No program opens the page here. It is %1").arg(page), "alarm");
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return strip;
}

QPushButton* GalleryDialog::button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
  QPushButton* made = pushButton(QString("dialog.figures.") + name, text, tip, parent);
  if (parent->layout() != nullptr) parent->layout()->addWidget(made);
  return made;
}

}  // namespace underact::gui
