#pragma once

namespace underact::gui {

class Actions;
class SceneView;
class ThemeWatcher;

/// The actions of the view: cameras, layers, theme.
void addViewActions(Actions& actions, SceneView& view, ThemeWatcher& theme);

}  // namespace underact::gui
