#pragma once
#include <string>

#include "app/serve/request.h"
#include "core/base/result.h"
#include "core/json/json.h"
#include "core/scene/description.h"

namespace underact::serve {

/// A constraint as the scene's file would have it, with its mesh or curve loaded, which may take seconds; any thread.
/// Problems: those of the constraint, with pointers into it.
Result<scene::Constraint> readConstraint(const scene::Description& scene, const json::Value& constraint);

/// The scene with one more constraint. is_named: the name was given, and must be free; else a number is appended.
/// Problems: the name is taken; there are too many.
Result<scene::Description> withConstraint(const scene::Description& scene, scene::Constraint constraint, bool is_named);

/// The scene without the constraint of that name. Problems: there is none; it is the last one.
Result<scene::Description> withoutConstraint(const scene::Description& scene, const std::string& name);

/// The scene with other values of the keys that say where a constraint is, and how large. over_time: it is to be
/// carried there. Problems: no such constraint; another key, with pointers into the values; one that cannot be carried.
Result<scene::Description> withMoved(const scene::Description& scene, const std::string& name,
                                     const json::Value& values, bool over_time);

/// The scene of a name: of a shipped one, or the absolute path of a file, with its meshes loaded. May take seconds; any
/// thread. Problems: those of the file, or no such name.
Result<scene::Description> openScene(const std::string& name);

/// The scene of a JSON text, with its meshes loaded. beside: a file whose folder relative names are meant in.
Result<scene::Description> sceneOf(const std::string& text, const std::string& beside);

/// The scene with the values of a request "set". Any thread. Problems: those of the request, or of a value.
Result<scene::Description> editedBy(const Request& request, const scene::Description& scene);

/// The list of values for a request "get": JSON. Any thread. Problems: those of the request, or of a path.
Result<std::string> valuesFor(const Request& request, const scene::Description& scene);

/// All settings of the scene as the list of an answer: JSON.
std::string settingsText(const scene::Description& scene);

}  // namespace underact::serve
