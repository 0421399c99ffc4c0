#pragma once

namespace underact::gui {

class Actions;
class Document;

/// "scene.left_handed"
void addLeftHandAction(Actions& actions, Document& document);

}  // namespace underact::gui
