#pragma once
#include <QMainWindow>
#include <QStringList>
#include <functional>
#include <vector>

namespace underact::gui {

class Actions;

/// Something that the palette can do.
struct PaletteEntry {
  QString text;
  QString kind;          // "Command", "Scene", the panel of a setting
  QString keys;          // its shortcut; empty: none
  QStringList searched;  // texts to search in, as of searchText(); the first is its own
  bool is_possible = true;
  std::function<void()> run;
};

/// Every action, everything that features offer by name, and every field of the panels, in this order.
std::vector<PaletteEntry> paletteEntries(Actions& actions, const QMainWindow& window);

/// Those that fit what is typed, the best first; of equal ones in their own order, what is possible before what is not.
std::vector<const PaletteEntry*> fitting(const std::vector<PaletteEntry>& entries, const QString& typed);

}  // namespace underact::gui
