#include "core/base/translate.h"
#include "core/scene/read_parts.h"

namespace underact::scene {
namespace {

/// A number for all axes, or one for each.
void readGain(const json::Value& value, const std::string& path, Vec3& into, Findings& findings) {
  if (value.kind == json::Kind::Number) {
    into.setConstant(value.number);
  } else if (value.kind == json::Kind::Array) {
    readNumber(value, path, into, findings);
  } else {
    isKind(value, json::Kind::Number, path,
           said(TRANSLATE_NOOP("problem", "a number, or a list of 3 numbers for x, y and z")), findings);
  }
}

}  // namespace

Sentence belongsToControl() {
  return said(TRANSLATE_NOOP("problem", "This is a part of the control, as in %1."),
              {"\"control\": {\"law\": \"PD\", \"velocity\": {\"filter\": \"kalman\"}}"});
}

Control readControl(const json::Value& value, const std::string& path, Findings& findings) {
  Control control;
  if (!isKind(value, json::Kind::Object, path,
              said(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"law\": \"P\", \"kp_N_per_mm\": 0.5}"}),
              findings)) {
    return control;
  }
  ObjectReader object(value, path, said(TRANSLATE_NOOP("problem", "a control")), findings);
  if (const json::Value* law = object.find("law")) {
    // PID uses every gain: where the law cannot be read, nothing is said of gains that it would not use.
    if (!readWord(*law, object.pathOf("law"), kLawWords, control.law, findings)) control.law = LawType::PID;
  }
  for (const GainField& field : kGainFields) {
    const json::Value* gain = object.find(field.key);
    if (gain != nullptr) readGain(*gain, object.pathOf(field.key), control.gains.*field.member, findings);
  }
  if (const json::Value* anisotropy = object.find("anisotropy")) {
    readWord(*anisotropy, object.pathOf("anisotropy"), kAnisotropyWords, control.anisotropy, findings);
  }
  if (const json::Value* space = object.find("space")) {
    readWord(*space, object.pathOf("space"), kSpaceWords, control.space, findings);
  }
  if (const json::Value* velocity = object.find("velocity")) {
    control.velocity = readVelocity(*velocity, object.pathOf("velocity"), findings);
  }
  if (const json::Value* passivity = object.find("passivity")) {
    readWord(*passivity, object.pathOf("passivity"), kPassivityWords, control.passivity, findings);
  }
  object.refuse("friction", belongsToConstraint());
  object.refuse("search", belongsToConstraint());
  object.refuseLater(kLaterKeys);
  object.finish();
  return control;
}

}  // namespace underact::scene
