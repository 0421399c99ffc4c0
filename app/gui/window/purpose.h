#pragma once
#include <QString>
#include <QStringList>
#include <vector>

namespace underact::gui {

/// What somebody does with the window. Panels, menus and tool bar show what that takes; all else is one step away: in
/// "All panels" of the rail, and in the palette.
struct Purpose {
  const char *key, *title, *tip;
  QStringList panels;   // in the rail, keys of panels
  QStringList opened;   // of them, in the default layout
  QStringList buttons;  // of the tool bar, behind Start and Stop: actions
  QStringList menus;    // beginnings of the names of actions in the menus

  bool hasInMenus(const QString& action) const;
};

/// In the order in which they are offered; the first is that of a new user.
const std::vector<Purpose>& purposes();

/// The one of that key, or the first.
const Purpose& purposeOf(const QString& key);

}  // namespace underact::gui
