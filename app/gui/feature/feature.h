#pragma once
#include <QString>
#include <functional>
#include <vector>

#include "app/gui/feature/help_page.h"
#include "app/gui/feature/panel.h"
#include "app/gui/feature/parts.h"

namespace underact::gui {

/// A dock of the window: its menu entry and its shortcut follow.
struct PanelRow {
  const char* key;  // "feel": the dock is named dock.feel, its action dock.feel
  const char* title;
  Qt::DockWidgetArea area;
  const char* shortcut;
  const char* tip;
  Panel* (*make)(const FeatureParts& parts, QWidget* parent);
  const char* behind = nullptr;  // the key of the panel whose place it takes when it is opened; closed at first
};

using Followers = std::vector<Follower*>;

/// What the window can do, one thing of it: a room with a feature.cpp that gives this row, and a line in the top
/// CMakeLists.txt. Without either of them the window does without.
struct FeatureRow {
  std::vector<PanelRow> panels = {};
  std::vector<HelpPage> pages = {};
  /// Before any panel is there: its actions, and what follows the servo beside panels. None: panels are all of it.
  void (*make)(const FeatureParts& parts, Followers& followers) = nullptr;
  /// A file of that name is its own, and which action opens it; null: it has none.
  bool (*opens)(const QString& path) = nullptr;
  const char* open_action = nullptr;
};

/// The action that opens a file with that name; empty: it is a scene.
QString openerOf(const QString& path, const std::vector<FeatureRow>& rows);

}  // namespace underact::gui
