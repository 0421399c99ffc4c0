#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/arm/sample.h"
#include "core/base/result.h"
#include "core/record/session.h"
#include "core/scene/description.h"

namespace underact::device {

/// A tick of a recording, with what a replay needs of it.
struct RecordedRow {
  arm::JointAngles q_rad{};
  float force_N = 0.0F;  // sent
  float error_m = 0.0F;
  std::uint32_t buttons = 0;
  bool begins_anew = false;  // not continuous with the row before: a start, a gap, another clock
  bool is_full = false;      // the ramps are complete: the whole force acts
};

/// A moment of a recording that a person or a fault marked.
struct RecordedMark {
  std::int64_t row = 0;
  std::string label;
  bool is_fault = false;
};

/// A scene that took effect.
struct RecordedScene {
  std::int64_t row = 0;
  scene::Description scene;
};

/// A recording in memory, one row per tick, the first tick in row 0. Immutable.
struct Recorded {
  std::string name;  // of the session, or its file
  std::string path;
  int rate_hz = 1000;
  double frozen_s = 0.0;
  std::string arm;  // the preset's key
  std::vector<RecordedRow> rows;
  std::vector<RecordedMark> marks;    // by row
  std::vector<RecordedScene> scenes;  // by row; those that have constraints
  Problems damage;                    // what could not be read of the file
  /// The scene in effect at a row; null: none was.
  const RecordedScene* sceneAt(std::int64_t row) const;
};

/// Callbacks and options of a load; any of them may be empty.
struct LoadWatch {
  std::function<void(double share)> progress;
  std::function<void(std::int64_t row, const servo::TickRecord&)> row;  // each readable one, in order
  const std::atomic<bool>* cancelled = nullptr;
  std::vector<std::string> files_in = {};  // folders to search for meshes and curves besides the session's
};

/// Reads a whole session. Where the arm gave no sample, or one that is not a number, and where ticks are missing, the
/// joints are those of the row before. Cost: 80 bytes per tick. Problems: as record::Session::open(); no ticks in it;
/// it was cancelled.
Result<std::shared_ptr<const Recorded>> loadRecorded(const std::string& path, const LoadWatch& watch = {});
/// Loads an open session.
Result<std::shared_ptr<const Recorded>> loadRecorded(record::Session& session, const LoadWatch& watch);

}  // namespace underact::device
