#include "tests/support/constraint_vectors.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/istreamwrapper.h>

#include <fstream>

namespace underact::test {
namespace {

using Json = rapidjson::Value;

double number(const Json& json) {
  return json.IsNumber() ? json.GetDouble() : kNotANumber;
}

Vec3 vector(const Json& json) {
  if (!json.IsArray()) return Vec3::Constant(kNotANumber);
  return {number(json[0]), number(json[1]), number(json[2])};
}

GoldenShape shapeOf(const Json& json, const std::string& name) {
  GoldenShape shape;
  shape.name = name;
  shape.type = json["type"].GetString();
  for (const char* key : {"point", "center"}) {
    if (json.HasMember(key)) shape.place = vector(json[key]);
  }
  for (const char* key : {"direction", "normal", "axis"}) {
    if (json.HasMember(key)) shape.direction = vector(json[key]);
  }
  if (json.HasMember("radius")) shape.radius = number(json["radius"]);
  return shape;
}

GoldenCase caseOf(const Json& json) {
  GoldenCase one;
  one.tag = json["tag"].GetString();
  one.P = vector(json["P"]);
  one.Q = vector(json["Q"]);
  one.force = vector(json["force"]);
  one.kp = Vec3::Constant(number(json["kp"]));
  one.degenerate = json["degenerate"].GetBool();
  one.distance = number(json["distance"]);
  if (json.HasMember("tol_abs_Q")) one.tol_Q = number(json["tol_abs_Q"]);
  if (json.HasMember("tol_abs_F")) one.tol_F = number(json["tol_abs_F"]);
  return one;
}

GoldenCase anisotropicCase(const Json& json) {
  GoldenCase one;
  one.tag = "anisotropic";
  one.P = vector(json["P"]);
  one.Q = vector(json["Q"]);
  one.force = vector(json["force_componentwise"]);
  one.kp = vector(json["kp_vec"]);
  one.distance = (one.Q - one.P).norm();
  // meta.tol: 64 ulp of the largest coordinate involved.
  one.tol_Q = 64 * 0x1p-52 * std::max(one.P.cwiseAbs().maxCoeff(), one.Q.cwiseAbs().maxCoeff());
  one.tol_F = one.tol_Q * one.kp.maxCoeff();
  return one;
}

ConstraintVectors read() {
  std::ifstream file(UNDERACT_TEST_DATA "/golden/constraints.json");
  rapidjson::IStreamWrapper stream(file);
  rapidjson::Document document;
  document.ParseStream<rapidjson::kParseFullPrecisionFlag>(stream);
  ConstraintVectors all;
  if (document.HasParseError()) {
    ADD_FAILURE() << "tests/golden/constraints.json cannot be read";
    return all;
  }
  for (const Json& set : document["shapes"].GetArray()) {
    GoldenSet read{shapeOf(set["shape"], set["name"].GetString()), {}};
    if (read.shape.name == "sphere_4") continue;
    for (const Json& one : set["cases"].GetArray()) read.cases.push_back(caseOf(one));
    all.sets.push_back(read);
  }
  for (const Json& one : document["extreme_optional"].GetArray()) {
    all.extreme.push_back({shapeOf(one["shape"], "extreme"), {caseOf(one["case"])}});
  }
  for (const Json& one : document["anisotropic"].GetArray()) {
    all.anisotropic.push_back({shapeOf(one["shape"], "anisotropic"), {anisotropicCase(one)}});
  }
  for (const Json& one : document["invalid"].GetArray()) {
    if (one.HasMember("shape")) all.invalid.push_back(shapeOf(one["shape"], one["expect"].GetString()));
  }
  for (const Json& one : document["clamp"].GetArray()) {
    all.clamp.push_back({vector(one["force"]), vector(one["clamped"]), number(one["max"])});
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
