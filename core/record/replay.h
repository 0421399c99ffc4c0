#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/record/session.h"

namespace underact::record {

/// The first number that did not come out as it was recorded.
struct Difference {
  std::int64_t tick = 0;
  std::string column;
};

/// What verifyReplay() found.
struct Verified {
  std::int64_t ticks = 0;             // that were compared and are the same to the bit
  std::optional<Difference> differs;  // none: all are
  Sentence unknown;  // why it could not go on, in a sentence: ticks are missing, or damaged; empty: it went through
};

/// Runs what went into each recorded tick through the recorded scenes again, from the servo's memory at the beginning
/// on, with every edit where it was, and compares all that came of it, column by column, to the last bit. Only what a
/// clock measured (lateness_us, tick_us) is left out. progress: 0 to 1; false: stop. files_in: folders where meshes and
/// curves are looked for besides that of the session. Problems: the file cannot be read, or was recorded by a version
/// with another memory; a mesh or a curve is not found.
Result<Verified> verifyReplay(Session& session, const std::function<bool(double)>& progress = {},
                              const std::vector<std::string>& files_in = {});

/// The recorded hand with another scene: the same joints, buttons, starts and stops at the same times, as if that scene
/// had been loaded just before. Calls tick() with each tick as it was recorded and as it is now. Damaged blocks are
/// left out, and the servo starts anew behind them. Problems: the scene does not compile; the file cannot be read.
Problems replayWith(Session& session, const scene::Description& scene,
                    const std::function<void(const servo::TickRecord& recorded, const servo::TickRecord& now)>& tick,
                    const std::function<bool(double)>& progress = {});

}  // namespace underact::record
