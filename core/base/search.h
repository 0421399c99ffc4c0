#pragma once
#include <cstdint>

namespace underact {

/// How the nearest point of a mesh or a curve is searched for. Global: in the tree, without memory. Local: along the
/// surface or the curve from the last tick's point to the first minimum, which need not be the global one. Hybrid: the
/// result of the local search bounds the search in the tree, which proves it the global minimum or finds that.
enum class Search : std::uint8_t { Hybrid, Global, Local };

}  // namespace underact
