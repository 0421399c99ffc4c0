#pragma once
#include <string>
#include <vector>

#include "core/sim/hand_script.h"
#include "core/tick/program.h"

namespace underact::lab {

/// Cost and error of one search method, along the path of a hand.
struct SearchFigures {
  Search search = Search::Hybrid;
  double p50_us = 0.0, p99_us = 0.0, max_us = 0.0;
  double worst_m = 0.0;         // how much farther away than the nearest of all the point is, at most
  double share_beside = 0.0;    // of the ticks in which it is a different point than the nearest of all
  double share_unproved = 0.0;  // of the ticks in which the search cannot prove that it is the nearest
};

/// A mesh or a curve of a program, and each search on it.
struct SearchTrade {
  std::size_t constraint = 0;
  bool is_mesh = false;
  std::size_t pieces = 0;               // triangles, or pieces of the curve
  std::vector<SearchFigures> searches;  // local, hybrid, global
};

/// Moves the tip along the path of the script, `ticks` times 1 / rate_hz, and queries each search of each mesh and
/// curve of the program, warm from tick to tick. Errors are against the search in the tree with no memory, in the same
/// doubles, which the tests hold against brute force. Times are single queries by the steady clock, what reading it
/// costs taken off: they are those of this machine, now. side is ignored: the nearest point is searched.
std::vector<SearchTrade> searchTrade(const tick::TickProgram& program, const sim::HandScript& hand, int rate_hz,
                                     int ticks);

}  // namespace underact::lab
