#include "app/gui/guide/guide_window.h"

#include <QDir>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gui/guide/guide_list.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/tight_layout.h"

namespace underact::gui {
namespace {

constexpr int kZoomStep = 10;

}  // namespace

GuideWindow::GuideWindow(guide::Guide guide, int zoom, QWidget* parent)
    : QWidget(parent, Qt::Window),
      guide_(std::move(guide)),
      search_(guide_),
      list_(new GuideList(guide_, this)),
      page_(new PageView(this)),
      field_(new QLineEdit(this)) {
  setObjectName("guide");
  setWindowTitle(tr("Guide"));
  resize(1040, 720);
  nameWidget(page_, "guide.page", tr("Page of the guide"));
  page_->setZoom(zoom);
  auto* halves = new QSplitter(this);
  halves->addWidget(list_);
  halves->addWidget(page_);
  halves->setStretchFactor(1, 1);
  const int beside = std::min(46 * fontMetrics().averageCharWidth(), width() / 3);
  halves->resize(size());  // the splitter divides its current size
  halves->setSizes({beside, width() - beside});
  halves->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->addWidget(buildBar());
  column->addWidget(halves, 1);
  connect(field_, &QLineEdit::textChanged, this, &GuideWindow::find);
  connect(list_, &GuideList::chosen, this, &GuideWindow::open);
  connect(page_, &PageView::asked, this, &GuideWindow::follow);
  for (QWidget* part : findChildren<QWidget*>()) part->installEventFilter(this);
  installEventFilter(this);
  go(0);
}

QWidget* GuideWindow::buildBar() {
  auto* bar = new QWidget(this);
  auto* row = tight<QHBoxLayout>(bar);
  const auto add = [&](const char* name, const QString& text, const QString& tip, auto&& run) {
    QPushButton* button = pushButton(name, text, tip, bar);
    connect(button, &QPushButton::clicked, this, run);
    row->addWidget(button);
    return button;
  };
  back_ = add("guide.back", tr("Back"), tr("Previous page (Alt+Left)"), [this] { go(-1); });
  forward_ = add("guide.forward", tr("Forward"), tr("Next page (Alt+Right)"), [this] { go(1); });
  nameWidget(field_, "guide.search", tr("Search the guide"));
  field_->setPlaceholderText(tr("Search the guide (Ctrl+F)"));
  field_->setToolTip(tr("Enter opens the selected result; F3 goes to the next match on the page."));
  field_->setClearButtonEnabled(true);
  row->addWidget(field_, 1);
  add("guide.smaller", tr("Smaller"), tr("Smaller text (Ctrl+minus)"),
      [this] { page_->setZoom(page_->zoom() - kZoomStep); });
  add("guide.larger", tr("Larger"), tr("Larger text (Ctrl+plus)"),
      [this] { page_->setZoom(page_->zoom() + kZoomStep); });
  add("guide.print", tr("Print…"), tr("Prints the page (Ctrl+P)"), [this] { askToPrint(this, "guide", paper()); });
  add("guide.pdf", tr("PDF…"), tr("Saves the page as PDF"),
      [this] { askToSavePdf(this, "guide", paper(), [this](const QString& path) { emit saved(path); }); });
  return bar;
}

/// The page shown. Where each section is a worksheet, each begins a sheet.
PaperPage GuideWindow::paper() const {
  const QString name = place().section('#', 0, 0);
  const guide::Entry* const entry = guide_.find(name.toStdString());
  if (entry == nullptr) return {};
  return {QString::fromStdString(entry->page.title), QString::fromStdString(entry->markdown),
          QString::fromStdString(guide_.folder), Author::Program, name == "experiments"};
}

int GuideWindow::zoom() const {
  return page_->zoom();
}

QString GuideWindow::file(const QString& name) const {
  return QDir(QString::fromStdString(guide_.folder)).filePath(name);
}

void GuideWindow::search(const QString& words) {
  field_->setText(words);
  field_->setFocus(Qt::ShortcutFocusReason);
}

void GuideWindow::find(const QString& typed) {
  const std::vector<std::string> words = guide::searchWords(typed.toStdString());
  list_->showHits(search_.find(typed.toStdString()), !words.empty());
  QStringList marked;
  for (const std::string& word : words) marked << QString::fromStdString(word);
  page_->mark(marked);
}

bool GuideWindow::open(const QString& place) {
  if (place == this->place()) return present(place);
  if (!present(place)) return false;
  places_.resize(at_ + 1);  // drop the pages ahead
  places_ << place;
  go(1);
  return true;
}

void GuideWindow::go(int steps) {
  const qsizetype to = at_ + steps;
  if (to >= 0 && to < places_.size()) {
    at_ = to;
    present(places_[at_]);
  }
  back_->setEnabled(at_ > 0);
  forward_->setEnabled(at_ + 1 < places_.size());
}

bool GuideWindow::present(const QString& place) {
  const QString name = place.section('#', 0, 0), anchor = place.section('#', 1);
  const guide::Entry* entry = guide_.find(name.toStdString());
  if (entry == nullptr) return false;
  page_->showPage(QString::fromStdString(entry->markdown), QString::fromStdString(guide_.folder), Author::Program);
  if (!anchor.isEmpty()) page_->scrollToAnchor(anchor);
  list_->showPage(name);
  setWindowTitle(tr("%1 – Guide").arg(QString::fromStdString(entry->page.title)));
  return true;
}

void GuideWindow::follow(const QUrl& link) {
  if (link.scheme() != "guide") return emit asked(link);
  open(link.path() + (link.hasFragment() ? "#" + link.fragment() : QString()));
}

/// Whether the key is one of this window's; really: and acts on it. The main window uses some of these keys as
/// shortcuts, which work in every window of the program; in this window they belong to the guide.
bool GuideWindow::doKey(int key, Qt::KeyboardModifiers modifiers, bool really) {
  const auto is = [&](int wanted, Qt::KeyboardModifiers with) {
    return key == wanted && (modifiers & ~Qt::KeypadModifier) == with;
  };
  const auto done = [really](auto&& what) {
    if (really) what();
    return true;
  };
  if (is(Qt::Key_F, Qt::ControlModifier)) {
    return done([this] {
      field_->setFocus(Qt::ShortcutFocusReason);
      field_->selectAll();
    });
  }
  if (is(Qt::Key_F3, {})) return done([this] { page_->toMark(true); });
  if (is(Qt::Key_F3, Qt::ShiftModifier)) return done([this] { page_->toMark(false); });
  if (is(Qt::Key_Left, Qt::AltModifier)) return done([this] { go(-1); });
  if (is(Qt::Key_Right, Qt::AltModifier)) return done([this] { go(1); });
  if (is(Qt::Key_P, Qt::ControlModifier)) return done([this] { askToPrint(this, "guide", paper()); });
  if (is(Qt::Key_W, Qt::ControlModifier)) return done([this] { close(); });
  if (is(Qt::Key_Minus, Qt::ControlModifier)) return done([this] { page_->setZoom(page_->zoom() - kZoomStep); });
  if (is(Qt::Key_0, Qt::ControlModifier)) return done([this] { page_->setZoom(100); });
  const bool is_plus = key == Qt::Key_Plus || key == Qt::Key_Equal;
  if (is_plus && modifiers.testFlag(Qt::ControlModifier))
    return done([this] { page_->setZoom(page_->zoom() + kZoomStep); });
  if (!field_->hasFocus()) return false;
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    return done([this] {
      if (list_->openHit()) page_->toMark(true);
    });
  }
  if (is(Qt::Key_Down, {})) return done([this] { list_->moveHit(1); });
  if (is(Qt::Key_Up, {})) return done([this] { list_->moveHit(-1); });
  return false;
}

bool GuideWindow::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(object, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (!doKey(key->key(), key->modifiers(), event->type() == QEvent::KeyPress))
    return QWidget::eventFilter(object, event);
  event->accept();  // before a shortcut takes it
  return true;
}

}  // namespace underact::gui
