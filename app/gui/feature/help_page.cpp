#include "app/gui/feature/help_page.h"

#include <QWidget>

namespace underact::gui {
namespace {

/// The row with the longest part that equals the name or is its prefix before a dot; null: none.
const HelpPage* rowOf(const QString& name, const std::vector<HelpPage>& pages) {
  const HelpPage* best = nullptr;
  qsizetype length = 0;
  for (const HelpPage& row : pages) {
    const QString part = QString::fromLatin1(row.part);
    if (part.size() <= length || (name != part && !name.startsWith(part + '.'))) continue;
    best = &row;
    length = part.size();
  }
  return best;
}

}  // namespace

QString helpPageOf(const QWidget* widget, const std::vector<HelpPage>& pages) {
  for (const QWidget* part = widget; part != nullptr; part = part->parentWidget()) {
    if (const HelpPage* row = rowOf(part->objectName(), pages)) return QString::fromLatin1(row->place);
  }
  return "start";
}

}  // namespace underact::gui
