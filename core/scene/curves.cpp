#include <cmath>

#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "core/scene/kept_curves.h"
#include "core/scene/meshes.h"
#include "core/scene/rules.h"

namespace underact::scene {
namespace {

using json::numberText;

constexpr double kFastest_mm_per_s = kMillimetrePerMetre * curve::kFastestGuide_m_per_s;
constexpr double kLongestLead_mm = 1000.0;

void readGuide(const json::Value& value, const std::string& path, CurveGuide& into, Findings& findings) {
  if (!isKind(value, json::Kind::Object, path,
              said(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"speed_mm_per_s\": 30}"}), findings))
    return;
  ObjectReader guide(value, path, said(TRANSLATE_NOOP("problem", "a guide")), findings);
  const auto read = [&](const char* key, double& number, bool is_required) {
    const json::Value* const found = guide.find(key, is_required);
    if (found != nullptr) readNumber(*found, guide.pathOf(key), number, findings);
  };
  read("speed_mm_per_s", into.speed_mm_per_s, true);
  read("t", into.t, false);
  read("lead_mm", into.lead_mm, false);
  guide.finish();
}

}  // namespace

void readCurve(ObjectReader& object, Curve& into) {
  readPlacement(object, into);
  if (const json::Value* kind = object.find("kind")) {
    readWord(*kind, object.pathOf("kind"), kCurveWords, into.kind, object.findings());
  }
  if (const json::Value* closed = object.find("closed")) {
    if (isKind(*closed, json::Kind::Bool, object.pathOf("closed"), kindName(json::Kind::Bool), object.findings()))
      into.closed = closed->boolean;
  }
  if (const json::Value* guide = object.find("guide")) {
    readGuide(*guide, object.pathOf("guide"), into.guide.emplace(), object.findings());
  }
}

void checkCurve(const Curve& curve, const Control& control, const Say& say) {
  checkPlacement("curve", curve.file, curve.scale_mm_per_unit, curve.X_WM, control, say);
  if (!curve.guide) return;
  const CurveGuide& guide = *curve.guide;
  if (!(guide.t >= 0.0 && guide.t <= 1.0)) {
    say("guide.t",
        said(TRANSLATE_NOOP(
                 "problem",
                 "This must be from 0 (to the guide alone) to 1 (to the nearest point alone); here it is %1."),
             {numberText(guide.t)}));
  }
  if (!(std::abs(guide.speed_mm_per_s) <= kFastest_mm_per_s)) {
    say("guide.speed_mm_per_s", said(TRANSLATE_NOOP("problem", "This must be from -2000 to 2000 mm/s; here it is %1."),
                                     {numberText(guide.speed_mm_per_s)}));
  }
  if (!(guide.lead_mm > 0.0 && guide.lead_mm <= kLongestLead_mm)) {
    say("guide.lead_mm", said(TRANSLATE_NOOP("problem", "This must be above 0 and at most 1000 mm; here it is %1."),
                              {numberText(guide.lead_mm)}));
  }
}

Result<target::CurvePath> makeCurvePath(const Curve& curve, const Place& place) {
  if (curve.points == nullptr)
    return Problems{{said(TRANSLATE_NOOP("problem", "The curve %1 is not loaded."), {json::shown(curve.file)}), place}};
  auto made = keptCurve(curve, place);
  if (!made) return made.problems();
  target::CurvePath path{std::move(made).value(), curve.search, {}};
  if (curve.guide) {
    path.guide = {curve.guide->t, kMetrePerMillimetre * curve.guide->speed_mm_per_s,
                  kMetrePerMillimetre * curve.guide->lead_mm};
  }
  return path;
}

}  // namespace underact::scene
