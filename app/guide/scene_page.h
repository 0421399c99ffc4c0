#pragma once
#include <string>

#include "core/base/result.h"

namespace underact::guide {

/// The guide's page of every key of a scene file, as Markdown, from the scenes' schema. Problems: a schema that cannot
/// be read, or a key that it does not describe.
Result<std::string> scenePage(const std::string& schema_file);

/// The guide's page of the scenes of a folder, in their order.
Result<std::string> sceneList(const std::string& folder);

}  // namespace underact::guide
