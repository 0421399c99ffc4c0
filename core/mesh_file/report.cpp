#include "core/mesh_file/report.h"

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/translate.h"
#include "core/mesh_file/union_report.h"

namespace underact::mesh_file {
namespace {

/// A number with three significant digits, never with an exponent.
std::string figure(double value) {
  if (!(std::isfinite(value) && std::abs(value) > 0.0)) return "0";
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  std::array<char, 400> text{};
  const double step = std::pow(10.0, -decimals);
  const double rounded = decimals >= 0 ? value : std::round(value / step) * step;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed,
                                 decimals > 0 ? decimals : 0);
  std::string digits(text.data(), end.ptr);
  if (digits.find('.') != std::string::npos) {
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
  }
  return digits;
}

Sentence lengthText(double units, double mm_per_unit) {
  return phrase(TRANSLATE_NOOP("problem", "%1 mm"), {shownNumber(figure(units * mm_per_unit))});
}

/// A sentence for one or for several, with the number as %1.
Sentence counted(std::int64_t count, const char* one, const char* more, const Sentence& second = {}) {
  return phrase(count == 1 ? one : more, {std::to_string(count), second});
}

void addLeftOut(const Facts& facts, std::vector<Sentence>& report) {
  if (facts.miscounted != 0)
    report.push_back(
        phrase(TRANSLATE_NOOP("problem", "The file declares %1 faces, but has the length of %2: these were read."),
               {std::to_string(facts.file_faces - facts.miscounted), std::to_string(facts.file_faces)}));
  if (facts.skipped_bytes > 0)
    report.push_back(phrase(TRANSLATE_NOOP("problem", "What belongs to no face was skipped: %1 B."),
                            {std::to_string(facts.skipped_bytes)}));
  const auto leftOut = [&report](std::int64_t count, const char* one, const char* more) {
    if (count > 0) report.push_back(counted(count, one, more));
  };
  leftOut(facts.not_finite,
          TRANSLATE_NOOP("problem", "%1 face was left out: one of its vertices is not a finite point."),
          TRANSLATE_NOOP("problem", "%1 faces were left out: they have vertices that are not finite points."));
  leftOut(facts.out_of_range,
          TRANSLATE_NOOP("problem", "%1 face was left out: it refers to a vertex that is not in the file."),
          TRANSLATE_NOOP("problem", "%1 faces were left out: they refer to vertices that are not in the file."));
  leftOut(facts.without_extent, TRANSLATE_NOOP("problem", "%1 face was left out: it has no extent."),
          TRANSLATE_NOOP("problem", "%1 faces were left out: they have no extent."));
  leftOut(facts.duplicates, TRANSLATE_NOOP("problem", "%1 face was left out: it is a duplicate."),
          TRANSLATE_NOOP("problem", "%1 faces were left out: they are duplicates."));
}

void addRepaired(const Facts& facts, double mm_per_unit, std::vector<Sentence>& report) {
  if (facts.welded > 0) {
    report.push_back(counted(
        facts.welded,
        TRANSLATE_NOOP("problem", "%1 vertex was merged with others at the same position, or nearer than %2."),
        TRANSLATE_NOOP("problem", "%1 vertices were merged with others at the same position, or nearer than %2."),
        lengthText(facts.weld_tolerance, mm_per_unit)));
  }
  if (facts.added_at_seams > 0) {
    report.push_back(counted(
        facts.added_at_seams,
        TRANSLATE_NOOP("problem",
                       "%1 vertex lies on an edge of another face. This face was divided there: the seam is no hole."),
        TRANSLATE_NOOP(
            "problem",
            "%1 vertices lie on edges of other faces. These faces were divided there: seams are no holes.")));
  }
  if (facts.turned > 0) {
    report.push_back(counted(
        facts.turned,
        TRANSLATE_NOOP("problem", "%1 face was turned over so that neighbours agree on which side is outside."),
        TRANSLATE_NOOP("problem", "%1 faces were turned over so that neighbours agree on which side is outside.")));
  }
  if (2 * facts.normals_against > facts.normals) {
    report.push_back(
        phrase(TRANSLATE_NOOP("problem",
                              "Most normals in the file point against the order of the vertices. Only the order counts "
                              "here: if outside and inside feel swapped, save the mesh with its faces turned over.")));
  }
}

void addRemaining(const Facts& facts, double mm_per_unit, std::vector<Sentence>& report) {
  if (const Sentence lost = precisionReport(facts, mm_per_unit); !lost.empty()) report.push_back(lost);
  if (facts.parts > 1) report.push_back(partsReport(facts));
  if (facts.closed_holes > 0) {
    report.push_back(holesReport(facts, mm_per_unit));
  } else if (facts.borders > 0) {
    report.push_back(counted(
        facts.borders,
        TRANSLATE_NOOP("problem", "The surface is open: %1 border, %2 long. The stylus can pass through the hole."),
        TRANSLATE_NOOP("problem",
                       "The surface is open: %1 borders, the longest %2 long. The stylus can pass through a hole."),
        lengthText(facts.longest_border, mm_per_unit)));
  }
  if (facts.crowded_edges > 0) {
    report.push_back(counted(facts.crowded_edges, TRANSLATE_NOOP("problem", "%1 edge has more than two faces."),
                             TRANSLATE_NOOP("problem", "%1 edges have more than two faces.")));
  }
  if (facts.clashing_edges > 0) {
    report.push_back(counted(
        facts.clashing_edges,
        TRANSLATE_NOOP("problem",
                       "The surface has no outside: at %1 edge its faces cannot agree, as on a Möbius strip."),
        TRANSLATE_NOOP("problem",
                       "The surface has no outside: at %1 edges its faces cannot agree, as on a Möbius strip.")));
  }
  if (const Sentence crosses = crossingReport(facts); !crosses.empty()) {
    report.push_back(crosses);
  } else if (facts.crossings_checked == 0 && facts.faces > 0) {
    report.push_back(
        phrase(TRANSLATE_NOOP("problem",
                              "The check for self-intersection was left out or not completed: there are too "
                              "many faces, or too many near each other.")));
  }
  if (facts.flat_faces > 0) {
    report.push_back(counted(
        facts.flat_faces,
        TRANSLATE_NOOP("problem", "%1 face is as narrow as a line. It is kept because such faces close seams."),
        TRANSLATE_NOOP("problem", "%1 faces are as narrow as a line. They are kept because such faces close seams.")));
  }
}

/// A tenth of the resolution of a PHANToM Omni (0.055 mm).
constexpr double kFeltStep_mm = 0.005;

/// Below this thickness a stylus that is held to the nearest point is pushed out on the other side. A wall has a proxy.
constexpr double kThin_mm = 1.0;

void addConsequences(const Facts& facts, double mm_per_unit, std::vector<Sentence>& report) {
  if (facts.thinnest > 0.0 && facts.thinnest * mm_per_unit < kThin_mm) {
    report.push_back(phrase(
        TRANSLATE_NOOP(
            "problem",
            "Part of it is thin, %1 on average: felt from both sides, it may let the stylus through; a wall does not."),
        {lengthText(facts.thinnest, mm_per_unit)}));
  }
  report.push_back(
      allowsWalls(facts)
          ? phrase(TRANSLATE_NOOP(
                "problem", "The mesh is closed: it can be felt from both sides, or as a wall from outside or inside."))
          : phrase(TRANSLATE_NOOP("problem", "The mesh can be felt from both sides only: %1."),
                   {noWallsReason(facts)}));
}

}  // namespace

Sentence partsReport(const Facts& facts) {
  if (facts.parts <= 1) return {};
  const std::string parts = std::to_string(facts.parts);
  if (facts.nested_parts == 0)
    return phrase(TRANSLATE_NOOP("problem", "The mesh consists of %1 separate parts."), {parts});
  const Sentence nested = phrase(TRANSLATE_NOOP("problem", "The mesh consists of %1 separate parts, %2 inside others."),
                                 {parts, std::to_string(facts.nested_parts)});
  if (facts.hollows == 0) return nested;
  return oneAfterAnother(
      {nested, counted(facts.hollows, TRANSLATE_NOOP("problem", "%1 of these is a hollow, which is felt from within."),
                       TRANSLATE_NOOP("problem", "%1 of these are hollows, which are felt from within."))});
}

Sentence holesReport(const Facts& facts, double mm_per_unit) {
  if (facts.closed_holes == 0) return {};
  return counted(
      facts.closed_holes,
      TRANSLATE_NOOP("problem", "%1 hole with a border of %2 was closed, so that the mesh has an inside."),
      TRANSLATE_NOOP("problem", "%1 holes, the longest border %2, were closed, so that the mesh has an inside."),
      lengthText(facts.longest_closed_hole, mm_per_unit));
}

Sentence precisionReport(const Facts& facts, double mm_per_unit) {
  if (facts.single_step * mm_per_unit < kFeltStep_mm) return {};
  return phrase(TRANSLATE_NOOP("problem",
                               "The mesh is so far from its origin that the single-precision numbers of the file have "
                               "steps of %1: smaller details are lost. Save it nearer to its origin."),
                {lengthText(facts.single_step, mm_per_unit)});
}

bool allowsWalls(const Facts& facts) {
  return facts.inside == Inside::United || (isClosed(facts) && facts.inside == Inside::AsItIs);
}

Sentence noWallsReason(const Facts& facts) {
  if (allowsWalls(facts)) return {};
  if (facts.faces == 0) return phrase(TRANSLATE_NOOP("problem", "it has no faces"));
  if (facts.border_edges > 0) return phrase(TRANSLATE_NOOP("problem", "it is open, so it has no inside"));
  if (facts.clashing_edges > 0) return phrase(TRANSLATE_NOOP("problem", "its faces cannot agree on an outside"));
  if (facts.crowded_edges > 0)
    return phrase(TRANSLATE_NOOP("problem", "edges with more than two faces leave the inside undefined"));
  return phrase(TRANSLATE_NOOP("problem", "it intersects itself too often to tell inside from outside"));
}

std::vector<Sentence> reportOf(const Facts& facts, double mm_per_unit) {
  std::vector<Sentence> report;
  addLeftOut(facts, report);
  addRepaired(facts, mm_per_unit, report);
  if (facts.faces == 0) {
    report.push_back(phrase(TRANSLATE_NOOP("problem", "No face is left, so there is nothing to feel.")));
    return report;
  }
  addRemaining(facts, mm_per_unit, report);
  addConsequences(facts, mm_per_unit, report);
  return report;
}

std::optional<Proposal> implausible(double largest_mm) {
  if (!(largest_mm > 0.0) || !std::isfinite(largest_mm)) return {};
  if (largest_mm >= kSmallest_mm && largest_mm <= kLargest_mm) return {};
  Proposal proposal;
  proposal.sentence = phrase(TRANSLATE_NOOP("problem", "Read as millimetres, the mesh is %1 mm long."),
                             {shownNumber(figure(largest_mm))});
  constexpr std::array<Unit, 4> kUnits{{{TRANSLATE_NOOP("problem", "metres"), 1000.0, 0.0},
                                        {TRANSLATE_NOOP("problem", "centimetres"), 10.0, 0.0},
                                        {TRANSLATE_NOOP("problem", "inches"), 25.4, 0.0},
                                        {TRANSLATE_NOOP("problem", "micrometres"), 0.001, 0.0}}};
  for (Unit unit : kUnits) {
    unit.size_mm = largest_mm * unit.mm_per_unit;
    if (unit.size_mm < kSmallest_mm || unit.size_mm > kLargest_mm) continue;
    proposal.sentence =
        oneAfterAnother({proposal.sentence, phrase(TRANSLATE_NOOP("problem", "In %1 it would be %2 mm."),
                                                   {phrase(unit.name), shownNumber(figure(unit.size_mm))})});
    proposal.units.push_back(unit);
  }
  if (proposal.units.empty()) {
    proposal.sentence = oneAfterAnother(
        {proposal.sentence,
         phrase(largest_mm < kSmallest_mm
                    ? TRANSLATE_NOOP("problem", "That is too small to feel: state a larger scale.")
                    : TRANSLATE_NOOP("problem", "That is far beyond the arm's reach: state a smaller scale."))});
  }
  return proposal;
}

}  // namespace underact::mesh_file
