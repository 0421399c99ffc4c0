#pragma once
#include <string>
#include <vector>

#include "core/sim/hand_script.h"
#include "core/tick/program.h"

namespace underact::lab {

/// What one way to seek costs and gives, along a hand's way.
struct SearchFigures {
  Search search = Search::Hybrid;
  double p50_us = 0.0, p99_us = 0.0, max_us = 0.0;
  double worst_m = 0.0;         // how much farther off than the nearest of all the point is, at most
  double share_beside = 0.0;    // of the ticks, in which it is another than the nearest of all
  double share_unproved = 0.0;  // in which the search itself does not know that it is the nearest
};

/// A mesh or a curve of a program, and each search on it.
struct SearchTrade {
  std::size_t constraint = 0;
  bool is_mesh = false;
  std::size_t pieces = 0;               // triangles, or pieces of the curve
  std::vector<SearchFigures> searches;  // local, hybrid, global
};

/// Moves the tip as the script wants it, `ticks` times 1 / rate_hz, and asks each search of each mesh and curve of the
/// program, warm from tick to tick. Errors are against the search in the tree with no memory, in the same doubles,
/// which the tests hold against brute force. Times are single queries by the steady clock, what reading it costs taken
/// off: they are this machine's, now. side does not count: it is the nearest point that is sought.
std::vector<SearchTrade> searchTrade(const tick::TickProgram& program, const sim::HandScript& hand, int rate_hz,
                                     int ticks);

}  // namespace underact::lab
