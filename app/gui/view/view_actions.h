#pragma once

namespace underact::gui {

class Actions;
class SceneView;
class ThemeWatcher;

/// The actions about how the scene is looked at: cameras, layers, theme.
void addViewActions(Actions& actions, SceneView& view, ThemeWatcher& theme);

}  // namespace underact::gui
