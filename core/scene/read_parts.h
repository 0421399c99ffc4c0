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
using json::nearestWord;
using json::notYet;
using json::ObjectReader;
using json::shown;

/// Keys of a scene, a constraint or a control that the format has, but not this version.
inline const std::vector<std::string> kLaterKeys{"damping"};

/// For "velocity" in the wrong object.
Sentence belongsToControl();

/// For "friction" and "search" in the wrong object.
Sentence belongsToConstraint();

/// A constraint; its name stays empty where the file gives none.
void readConstraint(const json::Value& value, const std::string& path, Constraint& into, Findings& findings);

/// "velocity" of a control.
Velocity readVelocity(const json::Value& value, const std::string& path, Findings& findings);

/// "teach" of the scene.
Teaching readTeaching(const json::Value& value, Findings& findings);

/// "control" of the scene or of one constraint.
Control readControl(const json::Value& value, const std::string& path, Findings& findings);

}  // namespace underact::scene
