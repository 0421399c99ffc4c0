#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/record/session.h"

namespace underact::record {

/// The first number that differs from the recorded one.
struct Difference {
  std::int64_t tick = 0;
  std::string column;
};

/// What verifyReplay() found.
struct Verified {
  std::int64_t ticks = 0;             // that were compared and are bit-identical
  std::optional<Difference> differs;  // none: all are
  std::vector<std::string> mended;    // laws that compute otherwise since the session was made, see mendedLaws()
  std::int64_t different_ticks = 0;   // of those that were run: all, where a law was mended
  Sentence unknown;  // why it ended early, in a sentence: ticks are missing or damaged; empty: it did not
};

/// Runs the input of each recorded tick through the recorded scenes again, from the servo's state at the beginning and
/// with every edit at its tick, and compares all results, column by column, to the last bit; except for measured times
/// (lateness_us, tick_us). progress: 0 to 1; false: stop. files_in: folders in which meshes and curves are looked for,
/// besides that of the session. Problems: the file cannot be read, or is of a version with another layout of the state;
/// a mesh or a curve is not found.
Result<Verified> verifyReplay(Session& session, const std::function<bool(double)>& progress = {},
                              const std::vector<std::string>& files_in = {});

/// Where a run that is made again is written, besides being compared: a new session with the header of the first one
/// and this identity.
struct RerunFile {
  std::string path;
  system::Existing existing = system::Existing::Refuse;
};

/// verifyReplay() that also writes what it computes into a new session, with the measured times of the first one.
/// Problems, too: it cannot be written.
Result<Verified> rerunFromInput(Session& session, const RerunFile& file,
                                const std::function<void(const servo::TickRecord&)>& tick,
                                const std::function<bool(double)>& progress = {},
                                const std::vector<std::string>& files_in = {});

/// Where two blocks of ticks differ.
struct BlockDifference {
  std::int64_t first = 0;   // row
  std::string column = {};  // the first in that row
  std::int64_t rows = 0;    // that differ, in all
};
/// Compares the bytes of the rows and columns that both have, except for measured times; none: they are the same.
std::optional<BlockDifference> differenceOf(const Block& a, const Block& b);

/// Replays the recorded hand with another scene: the same joints, buttons, starts and stops at the same times, as if
/// that scene had been loaded just before. Calls tick() with each tick as recorded and as computed now. Damaged blocks
/// are left out, and the servo restarts after them. Problems: the scene does not compile; the file cannot be read.
Problems replayWith(Session& session, const scene::Description& scene,
                    const std::function<void(const servo::TickRecord& recorded, const servo::TickRecord& now)>& tick,
                    const std::function<bool(double)>& progress = {});

}  // namespace underact::record
