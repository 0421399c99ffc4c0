#include "core/base/translate.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {

Sentence belongsToControl() {
  return phrase(TRANSLATE_NOOP("problem", "This belongs in the control, as in %1."),
                {"\"control\": {\"law\": \"PD\", \"velocity\": {\"filter\": \"kalman\"}}"});
}

Control readControl(const json::Value& value, const std::string& path, Findings& findings) {
  Control control;
  if (!isKind(value, json::JsonKind::Object, path,
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"law\": \"P\", \"kp_N_per_mm\": 0.5}"}),
              findings)) {
    return control;
  }
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a control")), findings);
  // PID uses every gain: where the law cannot be read, unused gains are not reported.
  if (value.find("law") != nullptr) control.law = LawType::PID;
  readSettings(object, control);
  if (const json::Value* velocity = object.find("velocity")) {
    control.velocity = readVelocity(*velocity, object.pathOf("velocity"), findings);
  }
  object.refuse("friction", belongsToConstraint());
  object.refuse("search", belongsToConstraint());
  object.refuseLater(kLaterKeys);
  object.finish();
  return control;
}

}  // namespace underact::scene
