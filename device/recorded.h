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

/// A tick of a recording, as far as a replay needs it.
struct RecordedRow {
  arm::JointAngles q_rad{};
  float force_N = 0.0F;  // sent
  float error_m = 0.0F;
  std::uint32_t buttons = 0;
  bool begins_anew = false;  // nothing leads here from the row before: a start, a gap, another clock
  bool is_full = false;      // the ramps let the whole force through
};

/// A moment of a recording that somebody, or a fault, marked.
struct RecordedMark {
  std::int64_t row = 0;
  std::string label;
  bool is_fault = false;
};

/// A scene that came into effect.
struct RecordedScene {
  std::int64_t row = 0;
  scene::Description scene;
};

/// A recording in memory, one row a tick, the first tick in row 0. Nobody changes it.
struct Recorded {
  std::string name;  // of the session, or its file
  std::string path;
  int rate_hz = 1000;
  double frozen_s = 0.0;
  std::string arm;  // the preset's key
  std::vector<RecordedRow> rows;
  std::vector<RecordedMark> marks;    // by row
  std::vector<RecordedScene> scenes;  // by row; those that have constraints
  Problems damage;                    // what of the file could not be read
  /// The scene in effect at a row; null: none was.
  const RecordedScene* sceneAt(std::int64_t row) const;
};

/// What a load tells and asks meanwhile; any of them may be empty.
struct LoadWatch {
  std::function<void(double share)> progress;
  std::function<void(std::int64_t row, const servo::TickRecord&)> row;  // each that can be read, in order
  const std::atomic<bool>* cancelled = nullptr;
  std::vector<std::string> files_in = {};  // folders where meshes and curves are looked for besides the session's
};

/// Reads a session whole. Where the arm gave no sample, or one that is no number, and where ticks are missing, the
/// joints are those of the row before. Cost: 64 bytes a tick. Problems: as record::Session::open(); no ticks in it; it
/// was cancelled.
Result<std::shared_ptr<const Recorded>> loadRecorded(const std::string& path, const LoadWatch& watch = {});
/// The same of a session that is open already.
Result<std::shared_ptr<const Recorded>> loadRecorded(record::Session& session, const LoadWatch& watch);

}  // namespace underact::device
