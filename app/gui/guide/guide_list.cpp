#include "app/gui/guide/guide_list.h"

#include <QListWidget>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <algorithm>

#include "app/gui/kit/message_label.h"

namespace underact::gui {

constexpr int kPlace = Qt::UserRole;

GuideList::GuideList(const guide::Guide& guide, QWidget* parent)
    : QStackedWidget(parent), contents_(new QTreeWidget(this)), hits_(new QListWidget(this)) {
  setObjectName("guide.list");
  nameWidget(contents_, "guide.contents", tr("Contents of the guide"));
  contents_->setHeaderHidden(true);
  contents_->setRootIsDecorated(false);
  contents_->setTextElideMode(Qt::ElideNone);
  for (const guide::Chapter& chapter : guide.chapters) {
    auto* heading = new QTreeWidgetItem(contents_, {QString::fromStdString(chapter.title)});
    heading->setFlags(Qt::ItemIsEnabled);
    QFont bold = contents_->font();
    bold.setBold(true);
    heading->setFont(0, bold);
    for (const std::string& name : chapter.pages) {
      auto* item = new QTreeWidgetItem(heading, {QString::fromStdString(guide.find(name)->page.title)});
      item->setData(0, kPlace, QString::fromStdString(name));
      item->setToolTip(0, item->text(0));
    }
    heading->setExpanded(true);
  }
  nameWidget(hits_, "guide.hits", tr("Search results"));
  hits_->setWordWrap(true);
  hits_->setResizeMode(QListView::Adjust);
  hits_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  addWidget(contents_);
  addWidget(hits_);
  connect(contents_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item != nullptr && !item->data(0, kPlace).isNull()) emit chosen(item->data(0, kPlace).toString());
  });
  connect(hits_, &QListWidget::itemClicked, this, &GuideList::open);
  connect(hits_, &QListWidget::itemActivated, this, &GuideList::open);
}

void GuideList::showPage(const QString& name) {
  const QSignalBlocker silent(contents_);
  for (QTreeWidgetItemIterator at(contents_); *at != nullptr; ++at) {
    if ((*at)->data(0, kPlace).toString() == name) contents_->setCurrentItem(*at);
  }
}

void GuideList::showHits(const std::vector<guide::Hit>& hits, bool is_search) {
  hits_->clear();
  for (const guide::Hit& hit : hits) {
    const QString page = QString::fromStdString(hit.page_title), title = QString::fromStdString(hit.title);
    auto* item = new QListWidgetItem(title.isEmpty() || title == page ? page : tr("%1 – %2").arg(page, title), hits_);
    if (!hit.excerpt.empty()) item->setText(item->text() + '\n' + QString::fromStdString(hit.excerpt));
    item->setData(kPlace, QString::fromStdString(hit.page + (hit.anchor.empty() ? "" : "#" + hit.anchor)));
  }
  if (is_search && hits.empty()) {
    auto* item = new QListWidgetItem(tr("Nothing was found."), hits_);
    item->setFlags(Qt::NoItemFlags);
  }
  if (!hits.empty()) hits_->setCurrentRow(0);
  setCurrentWidget(is_search ? static_cast<QWidget*>(hits_) : contents_);
}

bool GuideList::openHit() {
  const QListWidgetItem* item = currentWidget() == hits_ ? hits_->currentItem() : nullptr;
  open(item);
  return item != nullptr;
}

void GuideList::moveHit(int rows) {
  if (currentWidget() == hits_ && hits_->count() > 0)
    hits_->setCurrentRow(std::clamp(hits_->currentRow() + rows, 0, hits_->count() - 1));
}

void GuideList::open(const QListWidgetItem* item) {
  if (item != nullptr && !item->data(kPlace).isNull()) emit chosen(item->data(kPlace).toString());
}

}  // namespace underact::gui
