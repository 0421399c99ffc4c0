#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/record/session.h"

namespace underact::record {

/// The first number that differs from the recording.
struct Difference {
  std::int64_t tick = 0;
  std::string column;
};

struct Verified {
  std::int64_t ticks = 0;             // compared, and identical to the bit
  std::optional<Difference> differs;  // none: all are identical
  Sentence unknown;  // why it could not continue, as a sentence: ticks are missing or damaged; empty: it finished
};

/// Runs the recorded inputs of every tick through the recorded scenes again, beginning with the recorded state of the
/// servo and with every edit at its tick, and compares all results, column by column, to the last bit. Only what a
/// clock measured (lateness_us, tick_us) is left out. progress: 0 to 1; false: stop. files_in: further folders to
/// search for meshes and curves. Problems: the file cannot be read, or was recorded by a version with another state; a
/// mesh or a curve is not found.
Result<Verified> verifyReplay(Session& session, const std::function<bool(double)>& progress = {},
                              const std::vector<std::string>& files_in = {});

/// The recorded hand with another scene: the same joints, buttons, starts and stops at the same times, as if that scene
/// had been loaded just before. Calls tick() with each tick as recorded and as it is now. Damaged blocks are skipped,
/// and the servo restarts after them. Problems: the scene does not compile; the file cannot be read.
Problems replayWith(Session& session, const scene::Description& scene,
                    const std::function<void(const servo::TickRecord& recorded, const servo::TickRecord& now)>& tick,
                    const std::function<bool(double)>& progress = {});

}  // namespace underact::record
