#pragma once
#include <string>
#include <vector>

#include "core/json/object_reader.h"
#include "core/scene/description.h"
#include "core/scene/fields.h"
#include "core/scene/teaching.h"

namespace underact::scene {

// Internal to the room: what the readers of a scene's parts share.
using json::Findings;
using json::listed;
using json::notYet;
using json::ObjectReader;
using json::shown;

/// Keys of a scene, a constraint or a control that the format has and this version does not support.
inline const std::vector<std::string> kLaterKeys{"damping"};

/// The problem with "velocity" in the wrong object.
Sentence belongsToControl();

/// For "friction" and "search".
Sentence belongsToConstraint();

/// Reads a constraint; its name stays empty where the file gives none.
void readConstraint(const json::Value& value, const std::string& path, Constraint& into, Findings& findings);

/// Reads "velocity" of a control.
Velocity readVelocity(const json::Value& value, const std::string& path, Findings& findings);

/// Reads "teach" of the scene.
Teaching readTeaching(const json::Value& value, Findings& findings);

/// Reads "control" of the scene or of one constraint.
Control readControl(const json::Value& value, const std::string& path, Findings& findings);

}  // namespace underact::scene
