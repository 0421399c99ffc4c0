#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/record/replay.h"

namespace underact::device {

/// How a recorded run is made again.
struct RerunOptions {
  record::RerunFile out;              // empty path: it is only compared
  std::vector<std::string> files_in;  // folders in which meshes and curves are looked for, besides the session's
  std::function<void(const servo::TickRecord&)> tick = {};  // each one as it comes out now
  std::function<bool(double share)> progress = {};          // false: stop
};

/// A run that was made again.
struct RerunResult {
  record::Verified verified;
  bool is_from_hand = false;  // the simulated arm and its hand; false: from the recorded input
  std::uint64_t seed = 0;     // of that hand
};

/// Makes a recorded run again, from its file and the meshes and curves that it names by their checksums, and compares
/// every tick to the last bit. A run of the simulated arm by a scripted hand is made from hand, seed, arm model and
/// scene, with the recorded latencies; any other one, which a person or an edit had a part in, from the recorded input.
/// Problems: the file cannot be read; a mesh or a curve is not found; an arm that is another one here; the new file
/// cannot be written.
Result<RerunResult> rerun(record::Session& session, const RerunOptions& options = {});

}  // namespace underact::device
