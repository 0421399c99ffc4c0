#pragma once
#include <vector>

#include "core/chain/chain.h"

namespace underact::chain {

/// A chain as a modified Denavit-Hartenberg table, with the poses before and after it.
struct DhForm {
  std::vector<DhRow> rows;
  Pose X_WB = Pose::Identity();  // frame 0 in W
  Pose X_NT = Pose::Identity();  // the tool in the last frame
  double error_m = 0.0;          // the largest of the tip's position between both, over some configurations
  double error_rad = 0.0;        // of its orientation
};

/// The table of a chain: z of each frame along the joint's axis, in its sense, x along the common normal to the next;
/// the joints' values and limits stay. The first row is 0 (X_WB is the first joint's frame), and so are theta and d of
/// the last. Axes within 1e-9 rad count as parallel. Axes that are all but parallel have their common normal far away,
/// which costs digits: the errors say how many.
DhForm dhOf(const Chain& chain);

}  // namespace underact::chain
