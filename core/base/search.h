#pragma once
#include <cstdint>

namespace underact {

/// How the nearest point of a mesh or a curve is sought. Global: in the tree, with no memory. Local: from where it was
/// in the last tick along the surface or the curve, to the first minimum, which may be another than the least. Hybrid:
/// what the local search finds is the limit for the tree, which proves it the least of all or finds what is less.
enum class Search : std::uint8_t { Hybrid, Global, Local };

}  // namespace underact
