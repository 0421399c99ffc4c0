#pragma once
#include <string>
#include <vector>

#include "core/json/object_text.h"
#include "core/record/session.h"

namespace underact::record {

/// The laws of the tick and of the simulated arm that were mended since the first sessions, with their versions now, as
/// in {"laws": {"friction": 2}}. Whoever mends another adds a row in laws.cpp.
json::ObjectText lawVersions();

/// The scene of a session as its simulated arm was integrated, so that the run can be made again to the bit: before
/// version 2 of the law "integrator" only arms of the Omni's family heeded the scene.
scene::Description asIntegrated(Session& session, scene::Description scene);

/// Those laws that a session was made with in an older version, as far as one of its scenes uses them: what they
/// compute now may differ from what is recorded.
std::vector<std::string> mendedLaws(Session& session);

}  // namespace underact::record
