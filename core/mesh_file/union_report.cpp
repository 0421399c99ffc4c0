#include "core/mesh_file/union_report.h"

#include "core/base/translate.h"

namespace underact::mesh_file {
namespace {

Sentence crossesText(const Facts& facts) {
  const bool is_one = facts.crossings == 1;
  const char* pattern = facts.crossings_checked != 0
                            ? is_one ? TRANSLATE_NOOP("problem", "The surface intersects itself, at %1 pair of faces.")
                                     : TRANSLATE_NOOP("problem", "The surface intersects itself, at %1 pairs of faces.")
                        : is_one
                            ? TRANSLATE_NOOP("problem", "The surface intersects itself, at %1 pair of faces or more.")
                            : TRANSLATE_NOOP("problem", "The surface intersects itself, at %1 pairs of faces or more.");
  return phrase(pattern, {std::to_string(facts.crossings)});
}

Sentence feltText(const Facts& facts) {
  if (facts.within == 0)
    return phrase(TRANSLATE_NOOP("problem", "You feel the surface of the whole body, without walls inside it."));
  const char* pattern = facts.within == 1
                            ? TRANSLATE_NOOP("problem",
                                             "You feel the surface of the whole body, without walls inside it: %1 face "
                                             "there was left out.")
                            : TRANSLATE_NOOP("problem",
                                             "You feel the surface of the whole body, without walls inside it: %1 "
                                             "faces there were left out.");
  return phrase(pattern, {std::to_string(facts.within)});
}

}  // namespace

Sentence crossingReport(const Facts& facts) {
  const bool crosses = facts.crossings > 0;
  switch (facts.inside) {
    case Inside::United:
      if (!crosses && facts.within == 0 && facts.closed_holes > 0) return {};
      return crosses ? oneAfterAnother({crossesText(facts), feltText(facts)})
                     : oneAfterAnother(
                           {phrase(TRANSLATE_NOOP("problem", "Parts touch or contain each other.")), feltText(facts)});
    case Inside::Unsure:
      return oneAfterAnother(
          {crossesText(facts), phrase(TRANSLATE_NOOP("problem", "Inside and outside cannot be distinguished."))});
    case Inside::AsItIs:
      return crosses ? crossesText(facts) : Sentence();
  }
  return {};
}

}  // namespace underact::mesh_file
