#pragma once
#include <QString>
#include <functional>
#include <vector>

#include "app/gui/feature/help_page.h"
#include "app/gui/feature/panel.h"
#include "app/gui/feature/parts.h"
#include "app/gui/model/file_kind.h"

namespace underact::gui {

/// A panel of the window; its action is made from this row.
struct PanelRow {
  const char* key;  // "feel": the dock is named dock.feel, its action dock.feel
  const char* title;
  Qt::DockWidgetArea area;
  const char* tip;
  Panel* (*make)(const FeatureParts& parts, QWidget* parent);
  const char* behind = nullptr;    // key of the panel it shares a place with
  const char* shortcut = nullptr;  // of a panel that is opened often
};

using ServoListeners = std::vector<ServoListener*>;

/// One feature of the window: a room whose feature.cpp returns this row, and a line in the top CMakeLists.txt. Without
/// the line, the window does not have the feature.
struct FeatureRow {
  std::vector<PanelRow> panels = {};
  std::vector<HelpPage> pages = {};
  /// Called before any panel exists: adds its actions and its followers besides panels. Null: it has only panels.
  void (*make)(const FeatureParts& parts, ServoListeners& listeners) = nullptr;
  /// The action that opens files of a kind; null: it opens none.
  FileKind opens = FileKind::Scene;
  const char* open_action = nullptr;
};

/// The action that opens files of that kind; empty: no feature does, as with scenes.
QString openerOf(FileKind kind, const std::vector<FeatureRow>& rows);

}  // namespace underact::gui
