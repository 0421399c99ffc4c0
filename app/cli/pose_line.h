#pragma once
#include <string_view>

#include "core/base/result.h"
#include "core/base/types.h"

namespace underact::cli {

/// The pose of a stylus from a line of a stream, in SI.
struct PoseLine {
  Vec3 p_WT = Vec3::Zero();
  Mat3 R_WT = Mat3::Identity();
};

/// {"p_mm": [3], "R_WT": 3x3 (optional)}. Problems: all there are.
Result<PoseLine> readPoseLine(std::string_view text);

}  // namespace underact::cli
