#pragma once
#include <string>
#include <vector>

#include "core/sim/hand_script.h"
#include "core/tick/program.h"

namespace underact::lab {

/// Cost and error of one search along a hand's path.
struct SearchFigures {
  Search search = Search::Hybrid;
  double p50_us = 0.0, p99_us = 0.0, max_us = 0.0;
  double worst_m = 0.0;         // greatest excess of the distance over the global minimum
  double share_beside = 0.0;    // of ticks whose point is not the global minimum
  double share_unproved = 0.0;  // of ticks in which the search does not prove its point
};

/// A mesh or a curve of a program, and each search on it.
struct SearchTradeoff {
  std::size_t constraint = 0;
  bool is_mesh = false;
  std::size_t pieces = 0;               // triangles, or pieces of the curve
  std::vector<SearchFigures> searches;  // local, hybrid, global
};

/// Moves the tip along the script for `ticks` times 1 / rate_hz, and asks each search of each mesh and curve of the
/// program, warm from tick to tick. Errors are against the global search, in the same doubles, which the tests compare
/// with brute force. Times are single queries by the steady clock, less the cost of reading it, on this machine. Sides
/// are ignored: the nearest point is sought.
std::vector<SearchTradeoff> measureSearchTradeoff(const tick::TickProgram& program, const sim::HandScript& hand,
                                                  int rate_hz, int ticks);

}  // namespace underact::lab
