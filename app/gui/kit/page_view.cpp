#include "app/gui/kit/page_view.h"

#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QImageReader>
#include <QKeyEvent>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextCursor>
#include <QThreadPool>
#include <QWheelEvent>
#include <QtMath>
#include <algorithm>

#include "app/gui/kit/theme.h"
#include "app/gui/kit/words.h"
#include "app/page/html.h"
#include "app/page/style.h"
#include "core/base/translate.h"

namespace underact::gui {
namespace {

constexpr int kPageMargin = 16;
constexpr qsizetype kShort = 3;         // letters; shorter words must match whole
constexpr int kHighestPicture = 2000;   // logical pixels
constexpr qsizetype kMaxPictures = 20;  // of a stranger's page
constexpr int kSmallestZoom = 50, kLargestZoom = 300, kZoomStep = 10;

page::Colours coloursOf(const QPalette& palette) {
  const QColor ink = palette.color(QPalette::Text), ground = palette.color(QPalette::Base);
  const auto shade = [&](double share) { return mixed(ground, ink, share).name().toStdString(); };
  return {.ink = ink.name().toStdString(),
          .quiet = shade(0.68),
          .line = shade(0.2),
          .ground = ground.name().toStdString(),
          .soft = shade(0.07),
          .link = palette.color(QPalette::Link).name().toStdString(),
          .wrong = mixed(Theme().force_limited, ink, 0.25).name().toStdString()};
}

/// One thread, so that a page full of pictures leaves a core for the servo and the window.
QThreadPool& pictureThread() {
  static QThreadPool kPool;
  kPool.setMaxThreadCount(1);
  return kPool;
}

Problems tooManyPictures() {
  return {{phrase(TRANSLATE_NOOP("problem", "A page shows at most %1 pictures."), {std::to_string(kMaxPictures)})}};
}

/// The target of a link, in the form that asked() emits.
QUrl askedFor(const QUrl& link) {
  if (!link.isRelative()) return link;
  const QFileInfo file(link.path());
  QUrl url;
  const QString kind = file.suffix();
  url.setScheme(kind == "json" ? "scene" : kind == "ipynb" ? "notebook" : "guide");
  url.setPath(file.completeBaseName());
  if (link.hasFragment()) url.setFragment(link.fragment());
  return url;
}

}  // namespace

PageView::PageView(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  setAcceptDrops(false);                              // files are dropped on the window
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);  // so that pictures are fitted to a constant width
  document()->setDocumentMargin(kPageMargin);
  // With some fonts, rounding makes a table a few pixels too wide; as long as only the empty margin is cut off, there
  // is nothing to scroll to.
  connect(horizontalScrollBar(), &QScrollBar::rangeChanged, this, [this](int, int max) {
    setHorizontalScrollBarPolicy(max > kPageMargin ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  });
  setTextInteractionFlags(Qt::TextBrowserInteraction | Qt::TextSelectableByKeyboard);
  connect(this, &QTextBrowser::anchorClicked, this, &PageView::follow);
}

void PageView::showPage(const QString& markdown, const QString& folder, Author author) {
  const QByteArray text = markdown.toUtf8();
  const page::PageLimits limits = author == Author::Program ? page::PageLimits{} : page::kStrangersPage;
  page_ = page::readPage({text.data(), static_cast<std::size_t>(text.size())}, {}, {}, limits);
  if (!page_.cut.empty()) page_.html += "<p><i>" + page::escaped(sentenceText(page_.cut).toStdString()) + "</i></p>";
  folder_ = folder;
  author_ = author;
  sizes_.clear();
  render();
  verticalScrollBar()->setValue(0);
}

void PageView::render() {
  const int at = verticalScrollBar()->value();
  width_ = viewport()->width();
  for (const QUrl& name : pictures_.keys()) document()->addResource(QTextDocument::ImageResource, name, {});
  pictures_.clear();  // the document requests them again
  pictures_awaited_ = 0;
  rendering_ = std::make_shared<int>();
  document()->setDefaultStyleSheet(QString::fromStdString(page::pageStyle(coloursOf(palette()))));
  setHtml(QString::fromStdString(page_.html));
  mark(marked_);
  verticalScrollBar()->setValue(at);
}

void PageView::mark(const QStringList& words) {
  marked_ = words;
  QList<QTextEdit::ExtraSelection> marks;
  QTextEdit::ExtraSelection one;
  one.format.setBackground(mixed(palette().color(QPalette::Base), Theme().force, 0.45));
  for (const QString& word : words) {
    const QString end = word.size() < kShort ? "\\b" : "";  // "to" should not match "told"
    const QRegularExpression start(
        "\\b" + QRegularExpression::escape(word) + end,
        QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
    for (one.cursor = document()->find(start); !one.cursor.isNull(); one.cursor = document()->find(start, one.cursor))
      marks << one;
  }
  std::sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.cursor < b.cursor; });
  setExtraSelections(marks);
}

bool PageView::toMark(bool next) {
  const QList<QTextEdit::ExtraSelection> marks = extraSelections();
  if (marks.isEmpty()) return false;
  const QTextCursor here = textCursor();
  const auto is_after = [&](const auto& mark) { return mark.cursor.selectionStart() >= here.selectionEnd(); };
  const auto is_before = [&](const auto& mark) { return mark.cursor.selectionEnd() <= here.selectionStart(); };
  QTextCursor to = next ? marks.first().cursor : marks.last().cursor;
  if (next) {
    const auto found = std::find_if(marks.begin(), marks.end(), is_after);
    if (found != marks.end()) to = found->cursor;
  } else {
    const auto found = std::find_if(marks.rbegin(), marks.rend(), is_before);
    if (found != marks.rend()) to = found->cursor;
  }
  setTextCursor(to);
  ensureCursorVisible();
  return true;
}

int PageView::contentHeight() const {
  return qCeil(document()->size().height()) + 2 * frameWidth();
}

void PageView::setZoom(int percent) {
  percent = std::clamp(percent, kSmallestZoom, kLargestZoom);
  if (percent == zoom_) return;
  zoom_ = percent;
  QFont scaled = QApplication::font(this);
  scaled.setPointSizeF(scaled.pointSizeF() * percent / 100.0);
  setFont(scaled);
  emit zoomed(percent);
}

/// Never nothing: Qt itself would then read the file of that name, whatever it is.
QVariant PageView::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource) return QByteArray("");
  const auto known = pictures_.constFind(name);
  return known != pictures_.constEnd() ? *known : awaitPicture(name);
}

QSize PageView::roomForPicture() const {
  const double ratio = devicePixelRatioF();
  return {qRound(std::max(1, width_ - 2 * kPageMargin) * ratio), qRound(kHighestPicture * ratio)};
}

/// What is in its place until it is there.
QImage PageView::awaitPicture(const QUrl& name) {
  const bool is_own = author_ == Author::Program;
  QSize size = sizes_.value(name, {1, 1});
  if (is_own)
    size = fitted(QImageReader(QDir(folder_).filePath(name.path())).size().expandedTo(size), roomForPicture());
  QImage place(size, QImage::Format_ARGB32_Premultiplied);
  place.fill(Qt::transparent);
  place.setDevicePixelRatio(devicePixelRatioF());
  pictures_.insert(name, place);
  pictures_awaited_++;
  const std::string within = (is_own ? folder_ + "/.." : folder_).toStdString();
  // An address has no path here; nothing is ever fetched.
  const std::string path = name.isRelative() ? folder_.toStdString() + "/" + name.path().toStdString() : "/";
  const bool is_one_too_many = !is_own && pictures_.size() > kMaxPictures;
  pictureThread().start(
      [this, rendering = std::weak_ptr(rendering_), name, within, path, is_one_too_many, room = roomForPicture()] {
        if (rendering.expired()) return;
        const Result<QImage> read =
            is_one_too_many ? Result<QImage>(tooManyPictures()) : readPagePicture({within, path}, room);
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [this, rendering, name, read] {
              if (!rendering.expired()) putPicture(name, read);
            },
            Qt::QueuedConnection);
      });
  return place;
}

void PageView::putPicture(const QUrl& name, const Result<QImage>& read) {
  pictures_awaited_--;
  QImage& kept = pictures_[name];
  const QSize before = kept.size();
  kept = read ? read.value() : inWords(read.problems());
  kept.setDevicePixelRatio(devicePixelRatioF());
  sizes_.insert(name, kept.size());
  document()->addResource(QTextDocument::ImageResource, name, kept);
  if (kept.size() != before) document()->markContentsDirty(0, document()->characterCount());
  viewport()->update();
}

/// Why there is no picture, as one.
QImage PageView::inWords(const Problems& problems) const {
  const QString words = sentencesOf(problems);
  const QRect room(0, 0, std::max(1, width_ - 2 * kPageMargin), kHighestPicture);
  const QRect place = fontMetrics().boundingRect(room, Qt::TextWordWrap, words);
  QImage image(place.size().expandedTo({1, 1}) * devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(devicePixelRatioF());
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setFont(font());
  painter.setPen(QColor(QString::fromStdString(coloursOf(palette()).quiet)));
  painter.drawText(QRect(QPoint(), place.size()), Qt::TextWordWrap, words);
  return image;
}

void PageView::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !page_.html.empty()) render();
}

void PageView::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  const bool has_picture =
      std::any_of(page_.links.begin(), page_.links.end(), [](const page::Page::Link& link) { return link.is_picture; });
  if (has_picture && viewport()->width() != width_) render();
}

/// A caret would say that one can write here. Qt shows one where the keys can select while the focus comes; it comes
/// back with the first selection by keys.
void PageView::focusInEvent(QFocusEvent* event) {
  const Qt::TextInteractionFlags flags = textInteractionFlags();
  setTextInteractionFlags(Qt::TextBrowserInteraction);
  QTextBrowser::focusInEvent(event);
  setTextInteractionFlags(flags);
}

/// Without a caret these keys move the page; with Shift they select, as in a text.
void PageView::keyPressEvent(QKeyEvent* event) {
  using Action = QAbstractSlider::SliderAction;
  static const QHash<int, Action> kMoves{
      {Qt::Key_Up, QAbstractSlider::SliderSingleStepSub},   {Qt::Key_Down, QAbstractSlider::SliderSingleStepAdd},
      {Qt::Key_PageUp, QAbstractSlider::SliderPageStepSub}, {Qt::Key_PageDown, QAbstractSlider::SliderPageStepAdd},
      {Qt::Key_Home, QAbstractSlider::SliderToMinimum},     {Qt::Key_End, QAbstractSlider::SliderToMaximum}};
  const auto move = kMoves.constFind(event->key());
  const bool is_plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (!is_plain || move == kMoves.constEnd()) return QTextBrowser::keyPressEvent(event);
  verticalScrollBar()->triggerAction(*move);
}

void PageView::wheelEvent(QWheelEvent* event) {
  if (!event->modifiers().testFlag(Qt::ControlModifier)) return QTextBrowser::wheelEvent(event);
  const int notches = event->angleDelta().y();
  if (notches != 0) setZoom(zoom_ + (notches > 0 ? kZoomStep : -kZoomStep));
  event->accept();
}

void PageView::follow(const QUrl& link) {
  if (link.scheme() == "http" || link.scheme() == "https") return confirmAddress(link);
  if (link.isRelative() && link.path().isEmpty()) return scrollToAnchor(link.fragment());
  const QUrl to = askedFor(link);
  static const QStringList kKnown{"scene", "lesson", "action", "guide", "notebook"};
  if (kKnown.contains(to.scheme())) emit asked(to);
}

void PageView::confirmAddress(const QUrl& address) {
  auto* box = new QMessageBox(QMessageBox::Question, tr("Web page"),
                              tr("This link opens a web page outside the program:"), QMessageBox::Cancel, this);
  box->setObjectName("dialog.address");
  box->setInformativeText(address.toDisplayString());
  box->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  QPushButton* open = box->addButton(tr("Open in browser"), QMessageBox::AcceptRole);
  open->setObjectName("dialog.address.open");
  connect(open, &QPushButton::clicked, box, [address] { QDesktopServices::openUrl(address); });
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  box->show();
}

}  // namespace underact::gui
