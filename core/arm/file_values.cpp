#include "core/arm/file_values.h"

#include <cmath>

#include "core/base/nearest_rotation.h"
#include "core/base/translate.h"
#include "core/base/units.h"

namespace underact::arm {
namespace {

using json::Value;

constexpr double kFurthest_mm = 1e6;
constexpr const char* kTooLong = TRANSLATE_NOOP("problem", "A length must lie within 1e6 mm (1 km).");
constexpr const char* kNotFinite = TRANSLATE_NOOP("problem", "This is not a finite number.");

}  // namespace

double numberAt(json::ObjectReader& object, const char* key, bool required, double otherwise) {
  double number = otherwise;
  const Value* const value = object.find(key, required);
  if (value == nullptr) return number;
  json::readNumber(*value, object.pathOf(key), number, object.findings());
  if (std::isfinite(number)) return number;
  object.findings().add(*value, object.pathOf(key), phrase(kNotFinite));
  return otherwise;
}

double lengthAt(json::ObjectReader& object, const char* key, bool required) {
  const double length_mm = numberAt(object, key, required);
  if (std::abs(length_mm) > kFurthest_mm)
    object.findings().add(*object.find(key), object.pathOf(key), phrase(kTooLong));
  return kMetrePerMillimetre * length_mm;
}

Vec3 pointAt(json::ObjectReader& object, const char* key, bool required) {
  Vec3 point_mm = Vec3::Zero();
  const Value* const value = object.find(key, required);
  if (value == nullptr) return point_mm;
  json::readNumber(*value, object.pathOf(key), point_mm, object.findings());
  if (!point_mm.allFinite()) {
    object.findings().add(*value, object.pathOf(key), phrase(kNotFinite));
    return Vec3::Zero();
  }
  if (point_mm.cwiseAbs().maxCoeff() > kFurthest_mm)
    object.findings().add(*value, object.pathOf(key), phrase(kTooLong));
  return kMetrePerMillimetre * point_mm;
}

bool flagAt(json::ObjectReader& object, const char* key, bool otherwise) {
  const Value* const value = object.find(key);
  if (value == nullptr) return otherwise;
  const bool is_flag = isKind(*value, json::JsonKind::Bool, object.pathOf(key),
                              phrase(TRANSLATE_NOOP("problem", "true or false")), object.findings());
  return is_flag ? value->boolean : otherwise;
}

void readPose(json::ObjectReader& object, const char* key, bool required, Pose& X, Problems* notes) {
  const Value* const value = object.find(key, required);
  if (value == nullptr) return;
  const auto wrong = [&](const Value& at, const char* sentence) {
    object.findings().add(at, object.pathOf(key), phrase(sentence));
  };
  if (value->kind != json::JsonKind::Array || value->items.size() != 4)
    return wrong(*value, TRANSLATE_NOOP("problem", "This must be a list of 4 rows."));
  Eigen::Matrix4d matrix;
  for (std::size_t row = 0; row < 4; ++row) {
    const Value& numbers = value->items[row];
    if (numbers.kind != json::JsonKind::Array || numbers.items.size() != 4)
      return wrong(numbers, TRANSLATE_NOOP("problem", "Each row must have 4 numbers."));
    for (std::size_t column = 0; column < 4; ++column) {
      const Value& number = numbers.items[column];
      if (number.kind != json::JsonKind::Number || !std::isfinite(number.number))
        return wrong(number, TRANSLATE_NOOP("problem", "Each entry must be a number."));
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = number.number;
    }
  }
  const Mat3 R = matrix.topLeftCorner<3, 3>();
  if (Sentence sentence = rotationProblem(R); !sentence.empty())
    return object.findings().add(*value, object.pathOf(key), std::move(sentence));
  if (Sentence note = rotationNote(R); notes != nullptr && !note.empty())
    notes->push_back({std::move(note), {object.findings().file(), value->line, value->column, object.pathOf(key)}});
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
    return wrong(*value, TRANSLATE_NOOP("problem", "The last row must be 0, 0, 0, 1."));
  if (matrix.topRightCorner<3, 1>().cwiseAbs().maxCoeff() > kFurthest_mm) return wrong(*value, kTooLong);
  X.linear() = meantRotation(R);
  X.translation() = kMetrePerMillimetre * matrix.topRightCorner<3, 1>();
}

std::string poseText(const Pose& X) {
  std::string text;
  for (Eigen::Index row = 0; row < 4; ++row) {
    text += row == 0 ? "[" : ", ";
    for (Eigen::Index column = 0; column < 4; ++column) {
      const double number = X.matrix()(row, column) * (row < 3 && column == 3 ? kMillimetrePerMetre : 1.0);
      text += (column == 0 ? "[" : ", ") + json::numberText(number == 0.0 ? 0.0 : number);
    }
    text += "]";
  }
  return text + "]";
}

}  // namespace underact::arm
