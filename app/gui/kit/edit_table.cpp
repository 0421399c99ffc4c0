#include "app/gui/kit/edit_table.h"

#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>

#include "app/gui/kit/message_label.h"

namespace underact::gui {
namespace {

constexpr int kExact = Qt::UserRole;
constexpr int kChoices = Qt::UserRole + 1;

/// Starts from all digits of a number and emits what was typed instead of storing it.
class Typing : public QStyledItemDelegate {
 public:
  explicit Typing(EditTable* table) : QStyledItemDelegate(table), table_(table) {}

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override {
    const QString spoken = index.data(Qt::AccessibleTextRole).toString();
    const QStringList choices = index.data(kChoices).toStringList();
    QWidget* editor = nullptr;
    if (choices.isEmpty()) {
      auto* line = new QLineEdit(parent);
      line->setFrame(false);
      editor = line;
    } else {
      auto* box = new QComboBox(parent);
      box->addItems(choices);
      box->setAccessibleDescription(spoken);  // Qt reports the selection as its name
      // A choice takes effect at once, without Enter.
      connect(box, &QComboBox::activated, this, [this, box] {
        auto* self = const_cast<Typing*>(this);
        emit self->commitData(box);
        emit self->closeEditor(box);
      });
      editor = box;
    }
    nameWidget(editor, table_->objectName() + ".editor", spoken);
    return editor;
  }
  void setEditorData(QWidget* editor, const QModelIndex& index) const override {
    const QString exact = index.data(kExact).toString();
    if (auto* line = qobject_cast<QLineEdit*>(editor)) {
      if (line->text().isEmpty()) line->setText(exact);
      line->selectAll();
    } else if (auto* box = qobject_cast<QComboBox*>(editor)) {
      box->setCurrentText(exact);
    }
  }
  void setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const override {
    const auto* line = qobject_cast<QLineEdit*>(editor);
    const QString text = line != nullptr ? line->text() : static_cast<QComboBox*>(editor)->currentText();
    if (text == index.data(kExact).toString()) return;  // looked at, not changed
    emit table_->typed(index.row(), index.column(), text);
  }
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    QRect place = option.rect;  // a narrow cell's editor is wide enough for what is typed
    place.setWidth(std::max(place.width(), editor->fontMetrics().horizontalAdvance("−0000.0000") + 16));
    place.setHeight(std::max(place.height(), editor->minimumSizeHint().height()));
    editor->setGeometry(place);
  }

 private:
  EditTable* table_;
};

}  // namespace

EditTable::EditTable(const QString& object_name, const QString& name, QWidget* parent) : QTableWidget(parent) {
  setObjectName(object_name);
  setAccessibleName(name);
  setItemDelegate(new Typing(this));
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                  QAbstractItemView::AnyKeyPressed);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  horizontalHeader()->setSectionsClickable(false);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setMinimumSectionSize(8);
  horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignBottom);
  verticalHeader()->setHighlightSections(true);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().lineSpacing() + 8);
  verticalHeader()->setMinimumSectionSize(fontMetrics().lineSpacing() + 8);
}

bool EditTable::event(QEvent* event) {
  // F2 is also a shortcut of the window; in a table it edits, as in every table.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_F2) {
    event->accept();
    return true;
  }
  return QTableWidget::event(event);
}

void EditTable::setColumnHead(int column, const QString& head, const QString& tip, const QString& widest) {
  auto* item = new QTableWidgetItem(head);
  item->setToolTip(tip);
  setHorizontalHeaderItem(column, item);
  int width = fontMetrics().horizontalAdvance(widest);
  for (const QString& line : head.split('\n')) width = std::max(width, fontMetrics().horizontalAdvance(line));
  setColumnWidth(column, width + 12);
}

void EditTable::setCell(int row, int column, const Cell& cell) {
  QTableWidgetItem* one = item(row, column);
  if (one == nullptr) setItem(row, column, one = new QTableWidgetItem);
  if (one->text() != cell.shown) one->setText(cell.shown);
  one->setData(kExact, cell.exact);
  one->setData(kChoices, cell.choices);
  one->setData(Qt::AccessibleTextRole, QString("%1: %2").arg(cell.spoken, cell.shown));
  one->setToolTip(cell.tip);
  one->setTextAlignment((cell.choices.isEmpty() ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  one->setFlags(cell.editable ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable : Qt::ItemIsEnabled);
}

void EditTable::fitHeight() {
  const int rows = rowCount() * verticalHeader()->defaultSectionSize();
  const int bar =
      horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff ? 0 : horizontalScrollBar()->sizeHint().height();
  setFixedHeight(horizontalHeader()->sizeHint().height() + rows + bar + 4);
}

}  // namespace underact::gui
