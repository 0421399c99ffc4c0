#include "app/gui/palette/palette.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/kit/message_label.h"

namespace underact::gui {

constexpr int kMaxRows = 60;  // more are not read; a further letter finds them
constexpr int kWide_em = 40, kRowsSeen = 14;

Palette::Palette(std::vector<PaletteEntry> entries, QWidget* window)
    : QDialog(window),
      entries_(std::move(entries)),
      words_(new QLineEdit(this)),
      list_(new QListWidget(this)),
      note_(messageLabel("palette.note", tr("Hint"), "quiet", this)) {
  setObjectName("dialog.palette");
  setWindowTitle(tr("Find a command"));
  setAttribute(Qt::WA_DeleteOnClose);
  nameWidget(words_, "palette.words", tr("What to find"));
  words_->setPlaceholderText(tr("Command, scene, lesson, page or setting"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  nameWidget(list_, "palette.list", tr("Found"));
  list_->setUniformItemSizes(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideRight);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(list_);
  column->addWidget(note_);
  connect(words_, &QLineEdit::textChanged, this, &Palette::show);
  connect(words_, &QLineEdit::returnPressed, this, &Palette::run);
  connect(list_, &QListWidget::itemActivated, this, &Palette::run);
  show({});
  const int wide = std::min(kWide_em * fontMetrics().averageCharWidth() * 2, window->width() * 9 / 10);
  resize(wide, (kRowsSeen + 5) * fontMetrics().lineSpacing() * 5 / 4);
  move(window->mapToGlobal(QPoint((window->width() - width()) / 2, window->height() / 8)));
}

void Palette::show(const QString& typed) {
  shown_ = fitting(entries_, typed);
  const bool is_cut = shown_.size() > kMaxRows;
  if (is_cut) shown_.resize(kMaxRows);
  list_->clear();
  for (const PaletteEntry* const entry : shown_) {
    const QString text = entry->keys.isEmpty() ? entry->text : tr("%1  (%2)").arg(entry->text, entry->keys);
    auto* const item = new QListWidgetItem(tr("%1: %2").arg(entry->kind, text), list_);
    if (!entry->is_possible) item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
  }
  list_->setCurrentRow(0);
  updateText(note_, shown_.empty() ? tr("Nothing found. Try another word, or fewer letters.")
                    : is_cut       ? tr("Type more letters to narrow the list.")
                                   : tr("Press Enter to choose."));
}

void Palette::run() {
  const int row = list_->currentRow();
  if (row < 0 || row >= static_cast<int>(shown_.size())) return;
  const PaletteEntry& entry = *shown_[static_cast<std::size_t>(row)];
  if (!entry.is_possible) return note_->setText(tr("“%1” is not possible now.").arg(entry.text));
  QTimer::singleShot(0, parentWidget(), entry.run);  // once this dialog has given the focus back
  close();
}

/// The arrow keys move in the list while the words are being typed.
bool Palette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int step = key == Qt::Key_Down       ? 1
                   : key == Qt::Key_Up       ? -1
                   : key == Qt::Key_PageDown ? kRowsSeen
                   : key == Qt::Key_PageUp   ? -kRowsSeen
                                             : 0;
  if (step == 0 || list_->count() == 0) return QDialog::eventFilter(watched, event);
  list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
  return true;
}

}  // namespace underact::gui
