#pragma once
#include <Qt>
#include <span>

#include "app/gui/panel.h"

namespace underact::gui {

/// A dock of the window. A new panel is a row in panels.cpp; its dock, menu entry and shortcut follow.
struct PanelRow {
  const char* key;  // "feel": the dock is named dock.feel, its action dock.feel
  const char* title;
  Qt::DockWidgetArea area;
  const char* shortcut;
  const char* tip;
  Panel* (*make)(const PanelParts& parts, QWidget* parent);
  const char* behind = nullptr;  // the key of the panel whose place it takes when it is opened; closed at first
};

std::span<const PanelRow> panels();

}  // namespace underact::gui
