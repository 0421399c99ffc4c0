#include "core/lab/search_trade.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace underact::lab {
namespace {

using Clock = std::chrono::steady_clock;

/// An answer of a search, of whichever kind.
struct Answer {
  double distance_m = 0.0;
  bool is_proved = false;
};

double microsecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

/// The least that reading the clock twice takes.
double clockCost_us() {
  double least_us = 1e9;
  for (int run = 0; run < 1000; ++run) least_us = std::min(least_us, microsecondsSince(Clock::now()));
  return least_us;
}

/// ask(p_WT): with the search's memory of the last tick.
template <class Ask>
SearchFigures figuresOf(Search search, const std::vector<Vec3>& way, const std::vector<Answer>& nearest, Ask ask) {
  SearchFigures figures{search};
  const double clock_us = clockCost_us();
  std::vector<double> times_us;
  times_us.reserve(way.size());
  double beside = 0.0, unproved = 0.0;
  for (std::size_t tick = 0; tick < way.size(); ++tick) {
    const Clock::time_point start = Clock::now();
    const Answer answer = ask(way[tick]);
    times_us.push_back(std::max(0.0, microsecondsSince(start) - clock_us));
    const double farther_m = answer.distance_m - nearest[tick].distance_m;
    figures.worst_m = std::max(figures.worst_m, farther_m);
    beside += farther_m > 1e-12 * (1.0 + nearest[tick].distance_m) ? 1.0 : 0.0;  // above the rounding of both
    unproved += answer.is_proved ? 0.0 : 1.0;
  }
  const auto count = static_cast<double>(way.size());
  std::sort(times_us.begin(), times_us.end());
  const auto at = [&](double share) { return times_us[static_cast<std::size_t>(share * (count - 1.0))]; };
  figures.p50_us = at(0.5);
  figures.p99_us = at(0.99);
  figures.max_us = times_us.back();
  figures.share_beside = beside / count;
  figures.share_unproved = unproved / count;
  return figures;
}

/// asker(search) gives a search with a memory of its own.
template <class MakeAsker>
std::vector<SearchFigures> eachSearch(const std::vector<Vec3>& way, const MakeAsker& asker) {
  std::vector<Answer> nearest;
  nearest.reserve(way.size());
  auto ask_all = asker(Search::Global);
  for (const Vec3& p_WT : way) nearest.push_back(ask_all(p_WT));
  std::vector<SearchFigures> figures;
  for (const Search search : {Search::Local, Search::Hybrid, Search::Global})
    figures.push_back(figuresOf(search, way, nearest, asker(search)));
  return figures;
}

SearchTrade tradeOf(const target::MeshPlace& place, const std::vector<Vec3>& way) {
  SearchTrade trade;
  trade.is_mesh = true;
  trade.pieces = place.surface->triangles.faces.size();
  trade.searches = eachSearch(way, [&place](Search search) {
    return [&place, search, state = mesh::SearchState{}](const Vec3& p_WT) mutable {
      const mesh::Hit hit = nearestPoint(*place.surface, search, toMesh(place, p_WT), state);
      return Answer{place.scale_m * std::sqrt(hit.squared), hit.is_proved};
    };
  });
  return trade;
}

SearchTrade tradeOf(const target::CurvePath& path, const std::vector<Vec3>& way) {
  SearchTrade trade;
  trade.pieces = static_cast<std::size_t>(curve::pieceCount(*path.curve));
  trade.searches = eachSearch(way, [&path](Search search) {
    return [&path, search, state = curve::SearchState{}](const Vec3& p_WT) mutable {
      const curve::Nearest nearest = nearestPoint(*path.curve, search, p_WT, state);
      return Answer{nearest.distance_m, nearest.is_proved};
    };
  });
  return trade;
}

}  // namespace

std::vector<SearchTrade> searchTrade(const tick::TickProgram& program, const sim::HandScript& hand, int rate_hz,
                                     int ticks) {
  std::vector<Vec3> way;
  for (int tick = 0; tick < ticks; ++tick)
    way.push_back(wishAt(hand, std::int64_t{1'000'000'000} * tick / rate_hz).p_WT);
  std::vector<SearchTrade> trades;
  if (way.empty()) return trades;
  for (std::size_t index = 0; index < program.entries.size(); ++index) {
    const target::Constraint& constraint = program.entries[index].constraint;
    if (!constraint.mesh && !constraint.curve) continue;
    trades.push_back(constraint.mesh ? tradeOf(*constraint.mesh, way) : tradeOf(*constraint.curve, way));
    trades.back().constraint = index;
  }
  return trades;
}

}  // namespace underact::lab
