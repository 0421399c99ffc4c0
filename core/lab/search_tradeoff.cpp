#include "core/lab/search_tradeoff.h"

#include <algorithm>
#include <cmath>

#include "core/lab/stopwatch.h"

namespace underact::lab {
namespace {

/// The result of a search of either kind.
struct Answer {
  double distance_m = 0.0;
  bool is_proved = false;
};

/// ask(p_WT): a search that keeps its state from tick to tick.
template <class Ask>
SearchFigures figuresOf(Search search, const std::vector<Vec3>& hand_path, const std::vector<Answer>& nearest,
                        Ask ask) {
  SearchFigures figures{search};
  Stopwatch watch(hand_path.size());
  double beside = 0.0, unproved = 0.0;
  for (std::size_t tick = 0; tick < hand_path.size(); ++tick) {
    Answer answer;
    watch.time([&] { answer = ask(hand_path[tick]); });
    const double farther_m = answer.distance_m - nearest[tick].distance_m;
    figures.worst_m = std::max(figures.worst_m, farther_m);
    beside += farther_m > 1e-12 * (1.0 + nearest[tick].distance_m) ? 1.0 : 0.0;  // above the rounding of both
    unproved += answer.is_proved ? 0.0 : 1.0;
  }
  const auto count = static_cast<double>(hand_path.size());
  const Cost cost = watch.cost();
  figures.p50_us = 1e-3 * cost.p50_ns;
  figures.p99_us = 1e-3 * cost.p99_ns;
  figures.max_us = 1e-3 * cost.max_ns;
  figures.share_beside = beside / count;
  figures.share_unproved = unproved / count;
  return figures;
}

/// asker(search) gives a search with a state of its own.
template <class MakeAsker>
std::vector<SearchFigures> eachSearch(const std::vector<Vec3>& hand_path, const MakeAsker& asker) {
  std::vector<Answer> nearest;
  nearest.reserve(hand_path.size());
  auto ask_all = asker(Search::Global);
  for (const Vec3& p_WT : hand_path) nearest.push_back(ask_all(p_WT));
  std::vector<SearchFigures> figures;
  for (const Search search : {Search::Local, Search::Hybrid, Search::Global})
    figures.push_back(figuresOf(search, hand_path, nearest, asker(search)));
  return figures;
}

SearchTradeoff tradeOf(const target::MeshPlace& place, const std::vector<Vec3>& hand_path) {
  SearchTradeoff trade;
  trade.is_mesh = true;
  trade.pieces = place.surface->triangles.faces.size();
  trade.searches = eachSearch(hand_path, [&place](Search search) {
    return [&place, search, state = mesh::SearchState{}](const Vec3& p_WT) mutable {
      const mesh::Hit hit = nearestPoint(*place.surface, search, toMesh(place, p_WT), state);
      return Answer{std::abs(place.scale_m) * std::sqrt(hit.squared), hit.is_proved};
    };
  });
  return trade;
}

SearchTradeoff tradeOf(const target::CurvePath& path, const std::vector<Vec3>& hand_path) {
  SearchTradeoff trade;
  trade.pieces = static_cast<std::size_t>(curve::pieceCount(*path.curve));
  trade.searches = eachSearch(hand_path, [&path](Search search) {
    return [&path, search, state = curve::SearchState{}](const Vec3& p_WT) mutable {
      const curve::Nearest nearest = nearestPoint(*path.curve, search, p_WT, state);
      return Answer{nearest.distance_m, nearest.is_proved};
    };
  });
  return trade;
}

}  // namespace

std::vector<SearchTradeoff> measureSearchTradeoff(const tick::TickProgram& program, const sim::HandScript& hand,
                                                  int rate_hz, int ticks) {
  std::vector<Vec3> hand_path;
  for (int tick = 0; tick < ticks; ++tick)
    hand_path.push_back(setpointAt(hand, std::int64_t{1'000'000'000} * tick / rate_hz).p_WT);
  std::vector<SearchTradeoff> trades;
  if (hand_path.empty()) return trades;
  for (std::size_t index = 0; index < program.entries.size(); ++index) {
    const target::Goal& goal = program.entries[index].constraint.goal;
    const auto* place = std::get_if<target::MeshPlace>(&goal);
    const auto* path = std::get_if<target::CurvePath>(&goal);
    if (place == nullptr && path == nullptr) continue;
    trades.push_back(place != nullptr ? tradeOf(*place, hand_path) : tradeOf(*path, hand_path));
    trades.back().constraint = index;
  }
  return trades;
}

}  // namespace underact::lab
