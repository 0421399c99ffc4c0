#include <cmath>

#include "core/arm/model.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/json/object_reader.h"
#include "core/json/text.h"

namespace underact::arm {
namespace {

using json::Findings;
using json::ObjectReader;
using json::Value;

constexpr double kFurthest_mm = 1e6;
constexpr double kRotationError = 1e-6;

double numberAt(ObjectReader& object, const char* key, bool required, double otherwise = 0.0) {
  double number = otherwise;
  const Value* const value = object.find(key, required);
  if (value == nullptr) return number;
  json::readNumber(*value, object.pathOf(key), number, object.findings());
  if (std::isfinite(number)) return number;
  object.findings().add(*value, object.pathOf(key), said(TRANSLATE_NOOP("problem", "This is not a finite number.")));
  return otherwise;
}

double lengthAt(ObjectReader& object, const char* key) {
  const double length_mm = numberAt(object, key, true);
  if (std::abs(length_mm) > kFurthest_mm) {
    object.findings().add(*object.find(key), object.pathOf(key),
                          said(TRANSLATE_NOOP("problem", "A length must lie within 1e6 mm (1 km).")));
  }
  return kMetrePerMillimetre * length_mm;
}

/// A limit in rad or in degrees, whichever the file gives.
double limitAt(ObjectReader& object, const char* rad_key, const char* deg_key, double otherwise) {
  if (object.find(deg_key) != nullptr) return kRadPerDegree * numberAt(object, deg_key, false);
  return numberAt(object, rad_key, false, otherwise);
}

void readRow(const Value& value, std::size_t index, Model& model, Findings& findings) {
  const std::string path = "dh[" + std::to_string(index) + "]";
  if (!isKind(value, json::Kind::Object, path,
              said(TRANSLATE_NOOP("problem", "a row, as in {\"alpha_deg\": 90, \"a_mm\": 0, ...}")), findings))
    return;
  ObjectReader object(value, path, said(TRANSLATE_NOOP("problem", "a row of the DH table")), findings);
  chain::DhRow& row = model.rows[index];
  row.alpha_rad = kRadPerDegree * numberAt(object, "alpha_deg", true);
  row.a_m = lengthAt(object, "a_mm");
  row.theta_rad = kRadPerDegree * numberAt(object, "theta_deg", false);
  row.d_m = lengthAt(object, "d_mm");
  row.min = limitAt(object, "min_rad", "min_deg", -kInfinity);
  row.max = limitAt(object, "max_rad", "max_deg", kInfinity);
  if (!(row.min < row.max))
    findings.add(value, path,
                 said(TRANSLATE_NOOP("problem", "The joint's lower limit must be below its upper limit.")));
  model.limits.min_rad[index] = row.min, model.limits.max_rad[index] = row.max;
  if (const Value* const of_size = object.find("limits_of_size")) {
    if (isKind(*of_size, json::Kind::Bool, object.pathOf("limits_of_size"),
               said(TRANSLATE_NOOP("problem", "true or false")), findings)) {
      if (of_size->boolean && index != 4) {
        findings.add(*of_size, object.pathOf("limits_of_size"),
                     said(TRANSLATE_NOOP("problem", "Only joint 5 can have limits on the magnitude of its angle.")));
      }
      model.limits_wrist_size |= of_size->boolean;
    }
  }
  object.finish();
}

void readRows(ObjectReader& object, Model& model) {
  const Value* const list = object.find("dh", true);
  if (list == nullptr ||
      !isKind(*list, json::Kind::Array, "dh", said(TRANSLATE_NOOP("problem", "a list of six rows")), object.findings()))
    return;
  if (list->items.size() != model.rows.size()) {
    object.findings().add(
        *list, "dh",
        said(TRANSLATE_NOOP("problem", "An arm has six rows; this one has %1."), {std::to_string(list->items.size())}));
    return;
  }
  for (std::size_t index = 0; index < model.rows.size(); ++index) {
    readRow(list->items[index], index, model, object.findings());
  }
}

void readPose(ObjectReader& object, const char* key, bool required, Pose& X) {
  const Value* const value = object.find(key, required);
  if (value == nullptr) return;
  const auto wrong = [&](const char* sentence) { object.findings().add(*value, key, said(sentence)); };
  if (value->kind != json::Kind::Array || value->items.size() != 4)
    return wrong(TRANSLATE_NOOP("problem", "This must be a list of 4 rows."));
  Eigen::Matrix4d matrix;
  for (std::size_t row = 0; row < 4; ++row) {
    const Value& numbers = value->items[row];
    if (numbers.kind != json::Kind::Array || numbers.items.size() != 4)
      return wrong(TRANSLATE_NOOP("problem", "Each row must have 4 numbers."));
    for (std::size_t column = 0; column < 4; ++column) {
      const Value& number = numbers.items[column];
      if (number.kind != json::Kind::Number || !std::isfinite(number.number))
        return wrong(TRANSLATE_NOOP("problem", "Each entry must be a number."));
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = number.number;
    }
  }
  const Mat3 R = matrix.topLeftCorner<3, 3>();
  if (!(R * R.transpose()).isIdentity(kRotationError) || R.determinant() < 0.0)
    return wrong(TRANSLATE_NOOP("problem", "The upper left 3 x 3 numbers are not a rotation matrix."));
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    return wrong(TRANSLATE_NOOP("problem", "The last row must be 0, 0, 0, 1."));
  X.linear() = R;
  X.translation() = kMetrePerMillimetre * matrix.topRightCorner<3, 1>();
}

void readDevice(const Value& value, Model& model, Findings& findings) {
  if (!isKind(value, json::Kind::Object, "device", said(TRANSLATE_NOOP("problem", "an object in { }")), findings))
    return;
  ObjectReader object(value, "device", said(TRANSLATE_NOOP("problem", "a device description")), findings);
  DeviceFigures device;
  device.continuous_force_N = numberAt(object, "continuous_force_N", true, 1.0);
  if (!(device.continuous_force_N > 0.0))
    findings.add(value, "device.continuous_force_N", said(TRANSLATE_NOOP("problem", "This must be above 0.")));
  const Value* const counts = object.find("encoder_counts_per_turn", true);
  const std::string path = "device.encoder_counts_per_turn";
  if (counts != nullptr &&
      isKind(*counts, json::Kind::Array, path, said(TRANSLATE_NOOP("problem", "a list of six numbers")), findings)) {
    if (counts->items.size() != 6)
      findings.add(*counts, path, said(TRANSLATE_NOOP("problem", "This must be a list of six numbers.")));
    for (std::size_t joint = 0; joint < std::min<std::size_t>(6, counts->items.size()); ++joint) {
      const Value& count = counts->items[joint];
      device.counts_per_turn[joint] = count.number;
      if (!(count.kind == json::Kind::Number && count.number >= 1.0 && std::isfinite(count.number))) {
        findings.add(count, path + "[" + std::to_string(joint) + "]",
                     said(TRANSLATE_NOOP("problem", "This must be a number of at least 1.")));
      }
    }
  }
  object.finish();
  model.device = device;
}

Model readWhole(const Value& root, Findings& findings) {
  Model model;
  ObjectReader object(root, "", said(TRANSLATE_NOOP("problem", "an arm file")), findings);
  if (numberAt(object, "underact_arm", true, 1.0) != 1.0) {
    findings.add(*object.find("underact_arm"), "underact_arm",
                 said(TRANSLATE_NOOP("problem", "This program reads version 1 of arm files.")));
  }
  for (const auto& [key, text] :
       {std::pair{"name", &model.name}, {"title", &model.title}, {"provenance", &model.provenance}}) {
    if (const Value* const value = object.find(key, true)) json::readText(*value, key, *text, findings);
  }
  readRows(object, model);
  readPose(object, "X_WB", true, model.X_WB);
  readPose(object, "X_6T", false, model.X_6T);
  if (const Value* const device = object.find("device")) readDevice(*device, model, findings);
  object.finish();
  return model;
}

}  // namespace

Result<Model> readArm(std::string_view text, const std::string& file_name) {
  const Result<Value> root = json::parse(text, file_name);
  if (!root) return root.problems();
  Findings findings(file_name);
  if (!isKind(root.value(), json::Kind::Object, "",
              said(TRANSLATE_NOOP("problem", "an object, as in %1"), {"{\"underact_arm\": 1, ...}"}), findings)) {
    return findings.take();
  }
  const Model model = readWhole(root.value(), findings);
  if (model.device && !omniGeometry(model)) {
    const Value* const device = root.value().find("device");
    findings.add(*device, "device",
                 said(TRANSLATE_NOOP("problem",
                                     "Only an arm with the geometry of table 3.1 of the thesis can be a device; "
                                     "without \"device\" it can still be used for kinematics.")));
  }
  Problems problems = findings.take();
  if (!problems.empty()) return problems;
  return model;
}

Result<Model> readArmFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, said(TRANSLATE_NOOP("problem", "an arm")));
  if (!text) return text.problems();
  return readArm(text.value(), path);
}

}  // namespace underact::arm
