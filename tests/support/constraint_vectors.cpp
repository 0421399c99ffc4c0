#include "tests/support/constraint_vectors.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "core/json/json.h"

namespace underact::test {
namespace {

using Json = json::Value;

/// What lacks counts as null.
const Json& at(const Json& object, std::string_view key) {
  static const Json null;
  const Json* found = object.find(key);
  return found != nullptr ? *found : null;
}

double number(const Json& json) {
  return json.kind == json::JsonKind::Number ? json.number : kNotANumber;
}

Vec3 vector(const Json& json) {
  if (json.items.size() != 3) return Vec3::Constant(kNotANumber);
  return {number(json.items[0]), number(json.items[1]), number(json.items[2])};
}

GoldenShape shapeOf(const Json& json, const std::string& name) {
  GoldenShape shape;
  shape.name = name;
  shape.type = at(json, "type").text;
  for (const char* key : {"point", "center"}) {
    if (json.find(key) != nullptr) shape.place = vector(at(json, key));
  }
  for (const char* key : {"direction", "normal", "axis"}) {
    if (json.find(key) != nullptr) shape.direction = vector(at(json, key));
  }
  if (json.find("radius") != nullptr) shape.radius = number(at(json, "radius"));
  return shape;
}

GoldenCase caseOf(const Json& json) {
  GoldenCase one;
  one.tag = at(json, "tag").text;
  one.P = vector(at(json, "P"));
  one.Q = vector(at(json, "Q"));
  one.force = vector(at(json, "force"));
  one.kp = Vec3::Constant(number(at(json, "kp")));
  one.degenerate = at(json, "degenerate").boolean;
  one.distance = number(at(json, "distance"));
  if (json.find("tol_abs_Q") != nullptr) one.tol_Q = number(at(json, "tol_abs_Q"));
  if (json.find("tol_abs_F") != nullptr) one.tol_F = number(at(json, "tol_abs_F"));
  return one;
}

GoldenCase anisotropicCase(const Json& json) {
  GoldenCase one;
  one.tag = "anisotropic";
  one.P = vector(at(json, "P"));
  one.Q = vector(at(json, "Q"));
  one.force = vector(at(json, "force_componentwise"));
  one.kp = vector(at(json, "kp_vec"));
  one.distance = (one.Q - one.P).norm();
  // meta.tol: 64 ulp of the largest coordinate involved.
  one.tol_Q = 64 * 0x1p-52 * std::max(one.P.cwiseAbs().maxCoeff(), one.Q.cwiseAbs().maxCoeff());
  one.tol_F = one.tol_Q * one.kp.maxCoeff();
  return one;
}

ConstraintVectors read() {
  ConstraintVectors all;
  const std::string name = UNDERACT_TEST_DATA "/golden/constraints.json";
  std::ifstream file(name);
  const Result<Json> parsed = json::parse(std::string{std::istreambuf_iterator<char>(file), {}}, name);
  if (!parsed) {
    ADD_FAILURE() << describe(parsed.problems().at(0));
    return all;
  }
  const Json& document = parsed.value();
  for (const Json& set : at(document, "shapes").items) {
    GoldenSet read{shapeOf(at(set, "shape"), at(set, "name").text), {}};
    if (read.shape.name == "sphere_4") continue;
    for (const Json& one : at(set, "cases").items) read.cases.push_back(caseOf(one));
    all.sets.push_back(read);
  }
  for (const Json& one : at(document, "extreme_optional").items) {
    all.extreme.push_back({shapeOf(at(one, "shape"), "extreme"), {caseOf(at(one, "case"))}});
  }
  for (const Json& one : at(document, "anisotropic").items) {
    all.anisotropic.push_back({shapeOf(at(one, "shape"), "anisotropic"), {anisotropicCase(one)}});
  }
  for (const Json& one : at(document, "invalid").items) {
    if (const Json* shape = one.find("shape")) all.invalid.push_back(shapeOf(*shape, at(one, "expect").text));
  }
  for (const Json& one : at(document, "clamp").items) {
    all.clamp.push_back({vector(at(one, "force")), vector(at(one, "clamped")), number(at(one, "max"))});
  }
  return all;
}

template <class Chosen>
Result<shape::Shape> anyOf(Result<Chosen> made) {
  if (!made) return made.problems();
  return shape::Shape(std::move(made).value());
}

}  // namespace

const ConstraintVectors& constraintVectors() {
  static const ConstraintVectors vectors = read();
  return vectors;
}

Result<shape::Shape> makeShape(const GoldenShape& golden, double unit) {
  const Vec3 p_WC = unit * golden.place;
  const double radius = unit * golden.radius;
  if (golden.type == "point") return anyOf(shape::makePoint(p_WC, {}));
  if (golden.type == "sphere") return anyOf(shape::makeSphere(p_WC, radius, {}));
  if (golden.type == "line") return anyOf(shape::makeLine(p_WC, golden.direction, {}));
  if (golden.type == "plane") return anyOf(shape::makePlane(p_WC, golden.direction, {}));
  if (golden.type == "circle") return anyOf(shape::makeCircle(p_WC, golden.direction, radius, {}));
  if (golden.type == "cylinder") return anyOf(shape::makeCylinder(p_WC, golden.direction, radius, {}));
  return Problems{{"No such type: " + golden.type}};
}

double offAxis(const GoldenShape& golden, const Vec3& P) {
  const Vec3 from = P - golden.place;
  if (golden.type == "sphere") return from.norm();
  if (golden.type != "circle" && golden.type != "cylinder") return kInfinity;
  const Vec3 axis = (golden.direction / golden.direction.cwiseAbs().maxCoeff()).normalized();
  return from.cross(axis).norm();
}

}  // namespace underact::test
