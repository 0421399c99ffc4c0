#pragma once
#include <optional>
#include <vector>

#include "core/base/sentence.h"
#include "core/mesh_file/facts.h"

namespace underact::mesh_file {

/// What was repaired, what is left, and what it means for the hand: plain sentences, the ones about the hand last.
/// mm_per_unit: as the scene has it.
std::vector<Sentence> reportOf(const Facts& facts, double mm_per_unit);

/// side "outside" and "inside" may be asked of it, beside "both".
bool allowsWalls(const Facts& facts);

/// Why they may not; empty: they may.
Sentence whyNoWalls(const Facts& facts);

/// In how many parts it is; empty: in one.
Sentence partsReport(const Facts& facts);

/// The holes that were closed; empty: none.
Sentence holesReport(const Facts& facts, double mm_per_unit);

/// A unit that the file may have been written in.
struct Unit {
  const char* name;    // "metres", marked for translators
  double mm_per_unit;  // scale_mm_per_unit for it
  double size_mm;      // how long the mesh would be
};

struct Proposal {
  Sentence sentence;        // "The mesh would be 0.12 mm long as millimetres. In metres it would be 120 mm."
  std::vector<Unit> units;  // those that make it a plausible size, the likeliest first; may be empty
};

/// Sizes that a hand can feel as a whole, or in good part, mm.
inline constexpr double kSmallest_mm = 5.0;
inline constexpr double kLargest_mm = 2000.0;

/// What to ask where the largest extent, with the file's unit taken as mm, is none of these sizes; else nothing.
std::optional<Proposal> implausible(double largest_mm);

}  // namespace underact::mesh_file
