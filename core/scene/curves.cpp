#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/scene/compile.h"
#include "core/scene/curve_cache.h"
#include "core/scene/meshes.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
void readCurve(ObjectReader& object, Curve& into) {
  readPlacement(object, into);
  if (const json::Value* guide = object.find("guide"))
    readObject(*guide, object.pathOf("guide"), phrase(TRANSLATE_NOOP("problem", "a guide")), "{\"speed_mm_per_s\": 30}",
               into.guide.emplace(), object.findings());
  if (const json::Value* checksum = object.find("checksum"))
    readText(*checksum, object.pathOf("checksum"), into.checksum, object.findings());
}

void checkCurve(const Curve& curve, const Control& control, const Say& say) {
  checkPlacement("curve", curve.file, curve.scale_mm_per_unit, curve.X_WM, control, say);
  checkSettings(curve, say);
  if (curve.guide)
    checkSettings(*curve.guide, [&](const std::string& key, Sentence wrong) { say("guide." + key, std::move(wrong)); });
}

Result<target::CurvePath> makeCurvePath(const Curve& curve, const SourceLocation& place) {
  if (curve.points == nullptr)
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "The curve %1 is not loaded."), {json::shown(curve.file)}), place}};
  auto made = cachedCurve(curve, place);
  if (!made) return made.problems();
  target::CurvePath path{std::move(made).value(), curve.search, {}};
  if (curve.guide) {
    path.guide = {curve.guide->t, kMetrePerMillimetre * curve.guide->speed_mm_per_s,
                  kMetrePerMillimetre * curve.guide->lead_mm};
  }
  return path;
}

}  // namespace underact::scene
