#include "app/cli/pose_line.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/cli/json_lines.h"
#include "core/base/nearest_rotation.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/kinematics/units.h"

namespace underact::cli {
namespace {

using json::JsonKind;
using json::Value;

// Beyond it the squares of the coordinates, in m, could leave the range of a double.
constexpr double kFarthestTip_mm = 1e100;

bool readVector(const Value& value, Vec3& vector) {
  if (value.kind != JsonKind::Array || value.items.size() != 3) return false;
  for (std::size_t index = 0; index < 3; ++index) {
    const Value& item = value.items[index];
    if (item.kind != JsonKind::Number || !std::isfinite(item.number)) return false;
    vector[static_cast<Eigen::Index>(index)] = item.number;
  }
  return true;
}

bool readMatrix(const Value& value, Mat3& matrix) {
  if (value.kind != JsonKind::Array || value.items.size() != 3) return false;
  for (std::size_t row = 0; row < 3; ++row) {
    Vec3 entries;
    if (!readVector(value.items[row], entries)) return false;
    matrix.row(static_cast<Eigen::Index>(row)) = entries;
  }
  return true;
}

void checkKeys(const Value& object, Problems& problems) {
  for (std::size_t index = 0; index < object.keys.size(); ++index) {
    const std::string& key = object.keys[index];
    if (key != "p_mm" && key != "R_WT") {
      problems.push_back({"Unknown key \"" + key + "\"; the keys of a line are \"p_mm\" and \"R_WT\"."});
    } else if (std::find(object.keys.begin(), object.keys.begin() + static_cast<std::ptrdiff_t>(index), key) !=
               object.keys.begin() + static_cast<std::ptrdiff_t>(index)) {
      problems.push_back({"The key \"" + key + "\" appears twice."});
    }
  }
}

}  // namespace

Result<PoseLine> readPoseLine(std::string_view text) {
  const Result<Value> parsed = json::parse(text, "");
  if (!parsed) return parsed.problems();
  const Value& object = parsed.value();
  if (object.kind != JsonKind::Object) return Problems{{"A line is an object: {\"p_mm\": [x, y, z]}."}};
  Problems problems;
  checkKeys(object, problems);
  Vec3 p_WT_mm = Vec3::Zero();
  PoseLine line;
  const Value* p_mm = object.find("p_mm");
  if (p_mm == nullptr) {
    problems.push_back({"\"p_mm\" is missing: the position of the tip, three numbers."});
  } else if (!readVector(*p_mm, p_WT_mm)) {
    problems.push_back({"\"p_mm\" must be three finite numbers."});
  } else if (p_WT_mm.cwiseAbs().maxCoeff() > kFarthestTip_mm) {
    problems.push_back({"\"p_mm\" is beyond 1e100 mm."});
  }
  const Value* R_WT = object.find("R_WT");
  if (R_WT != nullptr && !readMatrix(*R_WT, line.R_WT)) {
    problems.push_back({"\"R_WT\" must be a rotation: three rows of three numbers, orthonormal, determinant +1."});
  } else if (std::string wrong = kinematics::rotationWrong(line.R_WT); !wrong.empty()) {
    problems.push_back({"\"R_WT\" " + wrong});
  }
  line.R_WT = meantRotation(line.R_WT);
  if (!problems.empty()) return problems;
  line.p_WT = kMetrePerMillimetre * p_WT_mm;
  return line;
}

}  // namespace underact::cli
