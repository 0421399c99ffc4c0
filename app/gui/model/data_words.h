#pragma once
#include <QString>
#include <string>

#include "core/lesson/lesson.h"
#include "core/scene/teaching.h"

namespace underact::gui {

/// A text of a scene's file in the window's language; of a scene that nobody translated: as it stands. What is shown,
/// never what is saved. Any thread.
QString sceneText(const std::string& text);

/// The same of all that is shown of it.
scene::Teaching translated(scene::Teaching teaching);
lesson::Lesson translated(lesson::Lesson lesson);

}  // namespace underact::gui
