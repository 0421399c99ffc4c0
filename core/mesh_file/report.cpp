#include "core/mesh_file/report.h"

#include <array>
#include <charconv>
#include <cmath>

namespace underact::mesh_file {
namespace {

/// With three digits that count, never as a power of ten.
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

std::string lengthText(double units, double mm_per_unit) {
  return figure(units * mm_per_unit) + " mm";
}

/// "1 face", "2 faces"; of: "face".
std::string countOf(std::int64_t count, const std::string& of) {
  return std::to_string(count) + " " + of + (count == 1 ? "" : "s");
}

std::string wereOf(std::int64_t count) {
  return count == 1 ? " was" : " were";
}

void addLeftOut(const Facts& facts, std::vector<std::string>& report) {
  const auto leftOut = [&report](std::int64_t count, const std::string& why_one, const std::string& why_many) {
    if (count > 0) {
      report.push_back(countOf(count, "face") + wereOf(count) + " left out: " + (count == 1 ? why_one : why_many) +
                       ".");
    }
  };
  leftOut(facts.not_finite, "a corner of it is not a finite point", "they have corners that are not finite points");
  leftOut(facts.out_of_range, "it names a corner that the file does not hold",
          "they name corners that the file does not hold");
  leftOut(facts.without_extent, "it has no extent", "they have no extent");
  leftOut(facts.duplicates, "it is there twice", "they are there more than once");
}

void addRepaired(const Facts& facts, double mm_per_unit, std::vector<std::string>& report) {
  if (facts.welded > 0) {
    report.push_back(countOf(facts.welded, "corner") + wereOf(facts.welded) +
                     " joined to others at the same place, or nearer than " +
                     lengthText(facts.weld_tolerance, mm_per_unit) + ".");
  }
  if (facts.turned > 0) {
    report.push_back(countOf(facts.turned, "face") + wereOf(facts.turned) +
                     " turned over, so that neighbours agree on which side is outside.");
  }
  if (2 * facts.normals_against > facts.normals) {
    report.push_back(
        "Most normals in the file point against the order of the corners. The order counts here, and the normals do "
        "not: if outside and inside feel exchanged, save the mesh with its faces turned over.");
  }
}

void addWhatIsLeft(const Facts& facts, double mm_per_unit, std::vector<std::string>& report) {
  if (facts.parts > 1) {
    report.push_back("The mesh is in " + countOf(facts.parts, "part") + " that do not hang together" +
                     (facts.nested_parts > 0 ? ", " + std::to_string(facts.nested_parts) +
                                                   " of them within others: a hollow is felt from within."
                                             : "."));
  }
  if (facts.borders > 0) {
    report.push_back("The surface is open: " + countOf(facts.borders, "border") + ", the longest " +
                     lengthText(facts.longest_border, mm_per_unit) + " around. The stylus can go through a hole.");
  }
  if (facts.crowded_edges > 0) {
    report.push_back(countOf(facts.crowded_edges, "edge") + (facts.crowded_edges == 1 ? " has" : " have") +
                     " more than two faces.");
  }
  if (facts.clashing_edges > 0) {
    report.push_back("The surface has no outside: at " + countOf(facts.clashing_edges, "edge") +
                     " its faces cannot agree, as on a strip that is twisted once.");
  }
  if (facts.crossings > 0) {
    report.push_back("The surface goes through itself, at " +
                     std::string(facts.crossings_checked != 0 ? "" : "least ") + countOf(facts.crossings, "pair") +
                     " of faces. Near there, outside and inside may be wrong.");
  } else if (facts.crossings_checked == 0 && facts.faces > 0) {
    report.push_back(
        "Whether the surface goes through itself was not looked for, or not to the end: it has too many "
        "faces, or too many near each other.");
  }
  if (facts.flat_faces > 0) {
    report.push_back(countOf(facts.flat_faces, "face") + (facts.flat_faces == 1 ? " is" : " are") +
                     " as narrow as a line. They stay, since they close seams.");
  }
}

/// The stylus is pushed out on the side that is nearer, so through a thin part.
constexpr double kThin_mm = 1.0;

void addWhatItMeans(const Facts& facts, double mm_per_unit, std::vector<std::string>& report) {
  if (facts.thinnest > 0.0 && facts.thinnest * mm_per_unit < kThin_mm) {
    report.push_back("A part of it is thin, " + lengthText(facts.thinnest, mm_per_unit) +
                     " in the mean: the stylus may be pushed through it.");
  }
  report.push_back(allowsWalls(facts)
                       ? "The mesh is closed: it can be felt from both sides, or as a wall from outside or inside."
                       : "The mesh can be felt from both sides only: " + whyNoWalls(facts) + ".");
}

}  // namespace

bool allowsWalls(const Facts& facts) {
  return isClosed(facts);
}

std::string whyNoWalls(const Facts& facts) {
  if (facts.faces == 0) return "it has no faces";
  if (facts.border_edges > 0) return "it is open, so that it has no inside";
  if (facts.clashing_edges > 0) return "its faces cannot agree on an outside";
  if (facts.crowded_edges > 0) return "edges with more than two faces leave open what is inside";
  return {};
}

std::vector<std::string> reportOf(const Facts& facts, double mm_per_unit) {
  std::vector<std::string> report;
  addLeftOut(facts, report);
  addRepaired(facts, mm_per_unit, report);
  if (facts.faces == 0) {
    report.push_back("No face is left: there is nothing to feel.");
    return report;
  }
  addWhatIsLeft(facts, mm_per_unit, report);
  addWhatItMeans(facts, mm_per_unit, report);
  return report;
}

std::optional<Proposal> implausible(double largest_mm) {
  if (!(largest_mm > 0.0) || !std::isfinite(largest_mm)) return {};
  if (largest_mm >= kSmallest_mm && largest_mm <= kLargest_mm) return {};
  Proposal proposal;
  proposal.sentence = "The mesh would be " + figure(largest_mm) + " mm long as millimetres.";
  constexpr std::array<Unit, 4> kUnits{
      {{"metres", 1000.0, 0.0}, {"centimetres", 10.0, 0.0}, {"inches", 25.4, 0.0}, {"micrometres", 0.001, 0.0}}};
  for (Unit unit : kUnits) {
    unit.size_mm = largest_mm * unit.mm_per_unit;
    if (unit.size_mm < kSmallest_mm || unit.size_mm > kLargest_mm) continue;
    proposal.sentence += std::string(" In ") + unit.name + " it would be " + figure(unit.size_mm) + " mm.";
    proposal.units.push_back(unit);
  }
  if (proposal.units.empty()) {
    proposal.sentence += largest_mm < kSmallest_mm ? " That is too small to be felt: state a larger scale."
                                                   : " That is far beyond the arm's reach: state a smaller scale.";
  }
  return proposal;
}

}  // namespace underact::mesh_file
