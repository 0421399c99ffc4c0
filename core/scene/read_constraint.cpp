#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/translate.h"
#include "core/scene/manipulators.h"
#include "core/scene/meshes.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

std::optional<Shape> shapeOfType(const json::Value& value, const std::string& path, Findings& findings) {
  std::vector<std::string> types;
  std::optional<Shape> shape;
  eachShape([&](auto one) {
    types.emplace_back(typeName(one));
    if (value.text == types.back()) shape = std::move(one);
  });
  if (!isKind(value, json::JsonKind::String, path, listed(types), findings)) return std::nullopt;
  if (shape) return shape;
  const std::string nearest = findings.nearest(value.text, types);
  findings.add(
      value, path,
      nearest.empty()
          ? phrase(TRANSLATE_NOOP("problem", "The type %1 is not known. Known types: %2."),
                   {shown(value.text), listed(types, "and")})
          : phrase(TRANSLATE_NOOP("problem", "The type %1 is not known. Did you mean \"%2\"? Known types: %3."),
                   {shown(value.text), nearest, listed(types, "and")}));
  return std::nullopt;
}

/// A value that passes all checks, in place of one that could not be read, so that check() reports only what was read.
void setHarmless(double& number) {
  number = 1.0;
}
void setHarmless(Vec3& number) {
  number.setOnes();
}
void setHarmless(Mat3& number) {
  number.setIdentity();
}

void readFields(ObjectReader& object, Shape& shape) {
  const auto read = [&](const auto& field, auto& number) {
    const json::Value* value = object.find(field.key, field.required);
    if (value == nullptr && !field.required) return;
    setHarmless(number);
    if (value != nullptr) readNumber(*value, object.pathOf(field.key), number, object.findings());
  };
  std::visit([&](auto& chosen) { eachField(chosen, read); }, shape);
}

/// Reads a name; empty where it cannot be read.
void readName(const json::Value& value, const std::string& path, std::string& into, Findings& findings) {
  if (value.kind == json::JsonKind::String && value.text.empty()) {
    findings.add(
        value, path,
        phrase(TRANSLATE_NOOP("problem", "The name is empty; write one, or remove the key to get a default name.")));
  }
  readText(value, path, into, findings);
}

void readSide(ObjectReader& object, Constraint& into) {
  if (!hasSides(into.shape)) {
    object.refuse("side", phrase(TRANSLATE_NOOP("problem", "A %1 has no inside and no outside; remove \"side\"."),
                                 {typeName(into.shape)}));
  } else {
    readSettings(object, into);
  }
}

void readInfluence(ObjectReader& object, Constraint& into) {
  if (!takesInfluence(into.shape)) {
    object.refuse(
        "influence",
        phrase(
            TRANSLATE_NOOP("problem", "A %1 has no influence; only a circle, a cylinder and a sphere have. Remove it."),
            {typeName(into.shape)}));
    return;
  }
  if (const json::Value* const value = object.find("influence"))
    readObject(*value, object.pathOf("influence"), phrase(TRANSLATE_NOOP("problem", "an influence")), "{\"t\": 0.5}",
               into.influence.emplace(), object.findings());
}

void readFriction(ObjectReader& object, Constraint& into) {
  if (!takesFriction(into.shape)) {
    object.refuse("friction",
                  phrase(TRANSLATE_NOOP("problem", "Nothing can slide along a %1, so it has no friction. Remove it."),
                         {typeName(into.shape)}));
    return;
  }
  if (const json::Value* const value = object.find("friction"))
    readObject(*value, object.pathOf("friction"), phrase(TRANSLATE_NOOP("problem", "a friction")),
               "{\"static\": 0.4, \"dynamic\": 0.3}", into.friction.emplace(), object.findings());
}

}  // namespace

Sentence belongsToConstraint() {
  return phrase(TRANSLATE_NOOP("problem", "This belongs in a constraint, as in %1."),
                {"{\"type\": \"mesh\", \"file\": \"a.stl\", \"friction\": {\"static\": 0.4}}"});
}

void readConstraint(const json::Value& value, const std::string& path, Constraint& into, Findings& findings) {
  into.place = {findings.file(), value.line, value.column, path};
  findings.remember(path, value);
  if (!isKind(value, json::JsonKind::Object, path,
              phrase(TRANSLATE_NOOP("problem", "an object, as in %1"),
                     {"{\"type\": \"point\", \"position_mm\": [0, 0, 0]}"}),
              findings)) {
    return;
  }
  ObjectReader object(value, path, phrase(TRANSLATE_NOOP("problem", "a constraint")), findings);
  if (const json::Value* name = object.find("name")) readName(*name, object.pathOf("name"), into.name, findings);
  std::optional<Shape> shape;
  if (const json::Value* type = object.find("type", true)) shape = shapeOfType(*type, object.pathOf("type"), findings);
  if (shape) {
    into.shape = *shape;
    object.setWhat(phrase(TRANSLATE_NOOP("problem", "a %1"), {typeName(into.shape)}));
    if (auto* robot = std::get_if<VirtualManipulator>(&into.shape)) {
      readManipulator(object, *robot);
    } else if (auto* mesh = std::get_if<Mesh>(&into.shape)) {
      readMesh(object, *mesh);
    } else if (auto* curve = std::get_if<Curve>(&into.shape)) {
      readCurve(object, *curve);
    } else {
      readFields(object, into.shape);
    }
    readSide(object, into);
    readInfluence(object, into);
    readFriction(object, into);
    if (!std::holds_alternative<Mesh>(into.shape) && !std::holds_alternative<Curve>(into.shape)) {
      object.refuse("search",
                    phrase(TRANSLATE_NOOP("problem",
                                          "The nearest point of a %1 is computed by a formula; only a mesh and "
                                          "a curve have a search. Remove it."),
                           {typeName(into.shape)}));
    }
  }
  if (const json::Value* control = object.find("control")) {
    into.control = readControl(*control, object.pathOf("control"), findings);
  }
  object.refuse("velocity", belongsToControl());
  object.refuseLater(kLaterKeys);
  object.finish(shape.has_value());
}

}  // namespace underact::scene
