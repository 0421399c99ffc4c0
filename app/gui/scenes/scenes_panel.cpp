#include "app/gui/scenes/scenes_panel.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScrollBar>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/icons.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/page_view.h"
#include "app/gui/kit/shipped.h"
#include "app/gui/model/document.h"

namespace underact::gui {
namespace {

constexpr int kPathRole = Qt::UserRole;
constexpr int kAbout = Qt::UserRole + 1;
constexpr int kTypeRole = Qt::UserRole + 2;
constexpr int kPicture_px = 40;  // minimum height

bool isHeading(const QListWidgetItem& item) {
  return item.data(kPathRole).isNull();
}

struct GroupRow {
  scene::Group group;
  const char* title;
};
constexpr GroupRow kGroups[] = {{scene::Group::Shapes, QT_TRANSLATE_NOOP("scenes", "Shapes")},
                                {scene::Group::Walls, QT_TRANSLATE_NOOP("scenes", "Walls")},
                                {scene::Group::Orientation, QT_TRANSLATE_NOOP("scenes", "Orientation")},
                                {scene::Group::Robots, QT_TRANSLATE_NOOP("scenes", "Virtual robots")},
                                {scene::Group::Meshes, QT_TRANSLATE_NOOP("scenes", "Meshes")},
                                {scene::Group::Curves, QT_TRANSLATE_NOOP("scenes", "Curves")},
                                {scene::Group::Stability, QT_TRANSLATE_NOOP("scenes", "Stability")},
                                {scene::Group::Arms, QT_TRANSLATE_NOOP("scenes", "Other arms")}};

/// The description of a scene as a page.
QString pageOf(const SceneEntry& entry) {
  QStringList parts;
  const scene::Teaching teaching = entry.teaching.value_or(scene::Teaching{});
  const auto add = [&parts](const QString& heading, const std::string& text) {
    if (!text.empty()) parts << QString("**%1** %2").arg(heading, QString::fromStdString(text));
  };
  add(ScenesPanel::tr("Feel:"), teaching.feel);
  add(ScenesPanel::tr("Try:"), teaching.try_this);
  add(ScenesPanel::tr("Equation:"), teaching.equation);
  parts << entry.about;
  return parts.join("\n\n");
}

}  // namespace

ScenesPanel::ScenesPanel(const Parts& parts, QWidget* parent)
    : Panel(parent),
      parts_(parts),
      shipped_(shippedScenes()),
      filter_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      about_(new PageView(this)) {
  nameWidget(filter_, "panel.scenes.filter", tr("Filter the scenes"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setClearButtonEnabled(true);
  nameWidget(list_, "panel.scenes.list", tr("Scenes"));
  list_->setFrameShape(QFrame::NoFrame);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  list_->setWordWrap(true);  // beside a picture there is room for two lines
  const int high = qMax(kPicture_px, qRound(2.4 * fontMetrics().height()));
  list_->setIconSize({high * 4 / 3, high});
  nameWidget(about_, "panel.scenes.about", tr("About the selected scene"));
  about_->setFrameShape(QFrame::NoFrame);
  about_->document()->setDocumentMargin(0);
  about_->viewport()->setBackgroundRole(QPalette::Window);  // looks like a part of the panel, not like a sheet of paper
  about_->setMinimumHeight(6 * fontMetrics().lineSpacing());
  auto* open = new QToolButton(this);
  open->setDefaultAction(parts_.actions.find("scene.open"));
  nameWidget(open, "panel.scenes.open", tr("Open a scene file"));
  open->setIconSize(QSize(1, 1) * fontMetrics().height());
  open->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  open->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  open->setFocusPolicy(Qt::StrongFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(
      notFoundLabel(system::Resource::Scenes, "panel.scenes.missing", tr("Why there are no scenes"), this));
  for (QWidget* widget :
       {static_cast<QWidget*>(filter_), static_cast<QWidget*>(list_), static_cast<QWidget*>(about_)}) {
    column->addWidget(widget, widget == list_ ? 3 : widget == about_ ? 2 : 0);
  }
  column->addWidget(open);

  parts_.actions.add(
      {"scenes.find", tr("&Find a scene"), QKeySequence("Ctrl+F"), tr("Moves the cursor to the filter.")},
      [this](const QVariantList&) {
        if (auto* dock = qobject_cast<QDockWidget*>(parentWidget())) {  // closed, or behind another panel
          dock->show();
          dock->raise();
        }
        filter_->setFocus(Qt::ShortcutFocusReason);
        filter_->selectAll();
        return true;
      });
  filter_->installEventFilter(this);
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filter(text);
    follows_ = false;  // what was looked for is seen, not what is open
    if (QListWidgetItem* const hit = firstHit()) list_->scrollToItem(hit);
  });
  connect(filter_, &QLineEdit::returnPressed, this, [this] {
    if (QListWidgetItem* const hit = firstHit()) openItem(hit);
  });
  connect(list_, &QListWidget::itemClicked, this, &ScenesPanel::openItem);
  connect(list_, &QListWidget::itemActivated, this, &ScenesPanel::openItem);
  connect(list_, &QListWidget::currentItemChanged, this, &ScenesPanel::describe);
  connect(list_->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] { follows_ = false; });
  connect(about_, &PageView::asked, this, [this](const QUrl& link) {
    if (link.scheme() == "scene")
      parts_.actions.perform("scene.open", QDir(sceneFolder()).filePath(link.path() + ".json"));
  });
  connect(&parts_.document, &Document::opened, this, &ScenesPanel::markOpen);
  connect(&parts_.recent, &RecentFiles::changed, this, &ScenesPanel::rebuild);
  rebuild();
}

void ScenesPanel::addHeading(const QString& text) {
  auto* item = new QListWidgetItem(text, list_);
  item->setFlags(Qt::NoItemFlags);
  QFont font = list_->font();
  font.setBold(true);
  item->setFont(font);
}

void ScenesPanel::addScene(const SceneEntry& entry) {
  auto* item = new QListWidgetItem(entry.title, list_);
  item->setData(kPathRole, entry.path);
  item->setData(kAbout, pageOf(entry));
  item->setData(kTypeRole, entry.type.isEmpty() ? QString("file") : entry.type);
  item->setToolTip(entry.title + "\n" + entry.path);
  item->setIcon(iconOf(*item));
}

/// The scene's picture; for a user's own scene, the icon of its type.
QIcon ScenesPanel::iconOf(const QListWidgetItem& item) const {
  const QString picture = scenePicture(item.data(kPathRole).toString(), theme_.dark);
  if (!picture.isEmpty()) return fileIcon(picture);
  const QIcon own = icon(item.data(kTypeRole).toString(), theme_);
  return own.isNull() ? icon("sphere", theme_) : own;  // of any other surface
}

QSize ScenesPanel::sizeHint() const {
  const int margins = layout()->contentsMargins().left() + layout()->contentsMargins().right();
  const int bar = list_->verticalScrollBar()->sizeHint().width();
  return {list_->sizeHintForColumn(0) + bar + margins, Panel::sizeHint().height()};
}

void ScenesPanel::rebuild() {
  list_->clear();
  for (const GroupRow& row : kGroups) {
    bool headed = false;
    for (const SceneEntry& entry : shipped_) {
      if (entry.teaching.value_or(scene::Teaching{}).group != row.group) continue;
      if (!std::exchange(headed, true)) addHeading(QCoreApplication::translate("scenes", row.title));
      addScene(entry);
    }
  }
  QStringList recent = parts_.recent.paths();
  if (!recent.isEmpty()) addHeading(tr("Recently opened"));
  for (const QString& path : recent) addScene(sceneEntry(path));
  filter(filter_->text());
  markOpen();
}

void ScenesPanel::filter(const QString& text) {
  QListWidgetItem* heading = nullptr;
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    if (isHeading(*item)) {
      heading = item;
      heading->setHidden(true);
      continue;
    }
    const bool fits = item->text().contains(text, Qt::CaseInsensitive) ||
                      item->data(kAbout).toString().contains(text, Qt::CaseInsensitive) ||
                      item->data(kTypeRole).toString().contains(text, Qt::CaseInsensitive);
    item->setHidden(!fits);
    if (fits && heading != nullptr) heading->setHidden(false);  // headings without scenes stay hidden
  }
}

QListWidgetItem* ScenesPanel::firstHit() const {
  for (int row = 0; row < list_->count(); ++row) {
    if (!isHeading(*list_->item(row)) && !list_->item(row)->isHidden()) return list_->item(row);
  }
  return nullptr;
}

/// Down leads from the filter to the first hit.
bool ScenesPanel::eventFilter(QObject* watched, QEvent* event) {
  QListWidgetItem* const hit = firstHit();
  const bool goes_down = watched == filter_ && event->type() == QEvent::KeyPress &&
                         static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down && hit != nullptr;
  if (!goes_down) return Panel::eventFilter(watched, event);
  list_->setCurrentItem(hit);
  list_->setFocus(Qt::ShortcutFocusReason);
  return true;
}

void ScenesPanel::openItem(QListWidgetItem* item) {
  const QString path = item->data(kPathRole).toString();
  // A double click comes twice; an open scene is not loaded (and ramped) again.
  if (path.isEmpty() || path == parts_.document.path()) return;
  parts_.actions.perform("scene.open", path);
  markOpen();  // opening may have failed or been cancelled; the list shows what is in effect
}

void ScenesPanel::markOpen() {
  list_->setCurrentItem(nullptr);  // a scene without a file is not in the list
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    if (isHeading(*item)) continue;
    const bool open = item->data(kPathRole).toString() == parts_.document.path();
    QFont font = list_->font();
    font.setBold(open);
    item->setFont(font);
    if (open) list_->setCurrentItem(item);
  }
  follows_ = true;
  keepInSight();
}

void ScenesPanel::keepInSight() {
  if (!follows_ || list_->currentItem() == nullptr) return;
  layout()->activate();  // its description may have taken space from the list
  list_->scrollToItem(list_->currentItem());
}

// A scene may be opened before the list has its size, for example from the command line.
void ScenesPanel::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  keepInSight();
}

void ScenesPanel::describe() {
  const QListWidgetItem* item = list_->currentItem();
  if (item == nullptr) return about_->showPage({}, {});
  about_->showPage(item->data(kAbout).toString(), QFileInfo(item->data(kPathRole).toString()).absolutePath());
}

void ScenesPanel::setTheme(const Theme& theme) {
  theme_ = theme;
  for (int row = 0; row < list_->count(); ++row) {
    QListWidgetItem* item = list_->item(row);
    if (!isHeading(*item)) item->setIcon(iconOf(*item));
  }
}

}  // namespace underact::gui
