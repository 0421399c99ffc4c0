#pragma once
#include <string>

#include "core/base/result.h"

namespace underact::guide {

/// The JSON Schema of scenes in a file, with what it says of each setting (type, words, range, default, description)
/// as the table of settings has it; the key of a new setting is added to its object. The rest stays as it is written.
/// Problems: no such file; no schema of scenes.
Result<std::string> sceneSchema(const std::string& schema_file);

}  // namespace underact::guide
