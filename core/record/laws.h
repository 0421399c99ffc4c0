#pragma once
#include <string>
#include <vector>

#include "core/json/object_text.h"
#include "core/record/session.h"

namespace underact::record {

/// The laws of the tick that were mended since the first sessions, with their versions now, as in
/// {"laws": {"friction": 2}}. Whoever mends another adds a row in laws.cpp.
json::ObjectText lawVersions();

/// Those laws that a session was made with in an older version, as far as one of its scenes uses them: what they
/// compute now may differ from what is recorded.
std::vector<std::string> mendedLaws(Session& session);

}  // namespace underact::record
