#pragma once
#include <QString>

#include "core/scene/description.h"

namespace underact::gui {

/// Where something from a file stands: as the file has it, or, where its middle would be outside the workspace, with
/// the middle in that of the workspace. mm.
Eigen::Matrix4d placeWithin(const Vec3& middle_mm);

/// A scene that holds the constraint alone, by the file's name. about: one sentence.
scene::Description sceneOfFile(const QString& path, const QString& about, scene::Constraint constraint);

}  // namespace underact::gui
