#include "app/gui/sessions/session_list.h"

#include <QDir>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/number_table.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/sessions/session_lines.h"

namespace underact::gui {
namespace {

constexpr int kPath = Qt::UserRole;
constexpr int kLinesOfList = 12, kLinesOfDetails = 4;

}  // namespace

SessionList::SessionList(QWidget* parent)
    : QWidget(parent),
      index_(this),
      search_(new QLineEdit(this)),
      count_(quietLabel("panel.sessions.count", {}, this)),
      list_(new QListWidget(this)),
      details_(quietLabel("panel.sessions.details", {}, this)) {
  search_->setObjectName("panel.sessions.search");
  search_->setAccessibleName(tr("Search sessions"));
  search_->setPlaceholderText(tr("Search"));
  search_->setToolTip(
      tr("Words from the name, notes, tags, subject, consent, scene, arm, markers or date. Each word must occur."));
  search_->setClearButtonEnabled(true);
  list_->setObjectName("panel.sessions.list");
  list_->setAccessibleName(tr("Recent sessions"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setUniformItemSizes(true);  // two lines each: a long list is laid out at once
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  list_->setMinimumHeight(kLinesOfList * fontMetrics().lineSpacing());
  list_->installEventFilter(this);
  details_->setAccessibleName(tr("Details of the selected session"));
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  details_->setMinimumHeight(kLinesOfDetails * fontMetrics().lineSpacing());
  auto* column = tight<QVBoxLayout>(this, 4);
  column->addWidget(search_);
  column->addWidget(count_);
  column->addWidget(list_, 1);
  column->addWidget(details_);
  connect(search_, &QLineEdit::textChanged, this, &SessionList::filter);
  connect(&index_, &SessionIndex::changed, this, &SessionList::rebuild);
  connect(list_, &QListWidget::itemActivated, this, &SessionList::activated);
  connect(list_, &QListWidget::currentItemChanged, this, [this] {
    describe();
    emit chosenChanged();
  });
  connect(list_, &QListWidget::customContextMenuRequested, this, [this](const QPoint& where) {
    if (list_->itemAt(where) != nullptr) emit menuAsked(list_->viewport()->mapToGlobal(where));
  });
  say(0);
}

void SessionList::setTools(QWidget* tools) {
  static_cast<QVBoxLayout*>(layout())->insertWidget(1, tools);
}

void SessionList::setFolder(const QString& folder) {
  folder_ = folder;
  index_.setFolder(folder);
  rebuild();  // its entries are of another folder
}

void SessionList::refresh() {
  index_.refresh();
  say(0);
}

void SessionList::focusSearch() {
  search_->setFocus(Qt::ShortcutFocusReason);
  search_->selectAll();
}

const SessionEntry* SessionList::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item == nullptr || item->isHidden() ? nullptr : index_.find(item->data(kPath).toString());
}

bool SessionList::choose(const QString& path) {
  for (int row = 0; row < list_->count(); ++row) {
    if (list_->item(row)->data(kPath).toString() != path) continue;
    list_->setCurrentRow(row);
    return !list_->item(row)->isHidden();
  }
  return false;
}

bool SessionList::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    emit deleteAsked();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void SessionList::rebuild() {
  const QListWidgetItem* current = list_->currentItem();
  QString kept = current == nullptr ? QString() : current->data(kPath).toString();
  if (index_.find(wanted_) != nullptr) kept = std::exchange(wanted_, {});
  {
    const QSignalBlocker silent(list_);
    list_->clear();
    for (const SessionEntry& entry : index_.entries()) {
      auto* item = new QListWidgetItem(linesOf(entry), list_);
      item->setData(kPath, entry.path);
      item->setToolTip(entry.path);
      if (entry.path == kept) list_->setCurrentItem(item);
    }
  }
  filter();
}

void SessionList::filter() {
  int shown = 0;
  for (int row = 0; row < list_->count(); ++row) {
    // A row an entry, in the same order: see rebuild().
    const bool fits = fitsSearch(index_.entries()[static_cast<std::size_t>(row)], search_->text());
    list_->item(row)->setHidden(!fits);
    shown += fits ? 1 : 0;
  }
  say(shown);
  describe();
  emit chosenChanged();
}

void SessionList::say(int shown) {
  const int all = list_->count();
  if (index_.isReading() && all == 0)
    count_->setText(tr("Reading the folder"));
  else if (all == 0)
    count_->setText(tr("No sessions yet. Press Record to make one."));
  else if (shown < all)
    count_->setText(tr("%1 of %2 sessions").arg(shown).arg(all));
  else
    count_->setText(all == 1 ? tr("1 session") : tr("%1 sessions").arg(all));
  count_->setToolTip(QDir::toNativeSeparators(folder_));
}

void SessionList::describe() {
  const SessionEntry* entry = chosen();
  details_->setText(entry == nullptr ? QString() : detailsOf(*entry));
}

}  // namespace underact::gui
