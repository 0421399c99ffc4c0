#pragma once
#include <cstdint>
#include <string>

#include "core/json/object_text.h"
#include "core/scene/description.h"
#include "core/servo/host.h"

namespace underact::record {

// What was run, for the table /provenance of a session. Members: the guide's page of the session file. No folder of a
// person's disk is in them, and nothing that the person said: that stays in the attributes, where it can be changed.

/// What all sessions of a recording have in common, without what the scene says: the program and its build, the
/// machine, the arm, the servo, and what the servo does not know. run: those members ("run": {...}). To be called by
/// the thread that calls the host.
json::ObjectText provenanceOf(const servo::Host& host, const json::ObjectText& run);
/// The provenance of one session. continues: that of which it is the next part; empty: of none.
json::ObjectText provenanceOf(const std::string& session_id, const std::string& continues,
                              const json::ObjectText& common);

/// How the servo runs now: {"servo": {...}}: rate, scheduling as asked for and as granted, limits.
json::ObjectText servoProvenance(const servo::Host& host);

/// What the scene says: the gains of each constraint as they act, defaults too, and the files of meshes and curves by
/// name and checksum.
json::ObjectText sceneProvenance(const scene::Description& scene);

/// A word that no other session has: 32 hexadecimal digits.
std::string newSessionId();

/// The system's clock, ns since 1970, UTC.
std::int64_t unixNow_ns();

}  // namespace underact::record
