#pragma once
#include <optional>
#include <vector>

#include "core/base/sentence.h"
#include "core/mesh_file/facts.h"

namespace underact::mesh_file {

/// What was repaired, what is left, and what it means for the hand: sentences, those about the hand last. mm_per_unit:
/// of the scene.
std::vector<Sentence> reportOf(const Facts& facts, double mm_per_unit);

/// Whether side "outside" and "inside" are possible, besides "both".
bool allowsWalls(const Facts& facts);

/// Why they are not; empty: they are.
Sentence noWallsReason(const Facts& facts);

/// Of how many separate parts the mesh consists; empty: of one.
Sentence partsReport(const Facts& facts);

/// The holes that were closed; empty: none.
Sentence holesReport(const Facts& facts, double mm_per_unit);

/// What was lost of a mesh far from its origin whose file has single-precision numbers; empty: nothing that can be
/// felt.
Sentence precisionReport(const Facts& facts, double mm_per_unit);

/// A unit that the file may have been written in.
struct Unit {
  const char* name;    // "metres", marked for translators
  double mm_per_unit;  // scale_mm_per_unit for it
  double size_mm;      // how long the mesh would be
};

/// What to ask about the unit of a file.
struct Proposal {
  Sentence sentence;        // "Read as millimetres, the mesh is 0.12 mm long. In metres it would be 120 mm."
  std::vector<Unit> units;  // those that make it a plausible size, the likeliest first; may be empty
};

/// The range of sizes that a hand can feel as a whole, or in good part, mm.
inline constexpr double kSmallest_mm = 5.0;
inline constexpr double kLargest_mm = 2000.0;

/// The question about the unit, if the largest extent, with the file's unit taken as mm, is outside that range.
std::optional<Proposal> implausible(double largest_mm);

}  // namespace underact::mesh_file
