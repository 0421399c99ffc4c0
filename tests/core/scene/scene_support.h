#pragma once
#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/scene/fields.h"
#include "core/scene/read.h"
#include "tests/support/property.h"

namespace underact::test {

/// "LINE:COLUMN: KEY: sentence" of each problem, or none.
inline std::vector<std::string> linesOf(const Problems& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems) {
    lines.push_back(std::to_string(problem.place.line) + ":" + std::to_string(problem.place.column) + ": " +
                    problem.place.key + ": " + problem.sentence);
  }
  return lines;
}

inline std::vector<std::string> problemsIn(const std::string& text) {
  const Result<scene::Description> read = scene::readScene(text, "test.json");
  return read ? std::vector<std::string>{} : linesOf(read.problems());
}

inline std::string joined(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

/// A scene of one constraint (or several, with commas), which begins in line 2, column 1.
inline std::string sceneWith(const std::string& constraint) {
  return "{\"underact_scene\": 1, \"title\": \"t\", \"constraints\": [\n" + constraint + "\n]}";
}

inline std::string fileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<std::filesystem::path> sceneFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(UNDERACT_SOURCE) + "/scenes")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".json" && name != "scene.schema.json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// To the last bit, so that -0 is not 0.
inline bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}
inline bool same(const Vec3& a, const Vec3& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}
inline bool same(const Mat3& a, const Mat3& b) {
  return std::memcmp(a.data(), b.data(), 9 * sizeof(double)) == 0;
}
template <scene::PlainShape Shape>
bool same(const Shape& a, const Shape& b) {
  bool all = true;
  eachField(a, [&](const auto& field, const auto& number) { all = all && same(number, b.*field.member); });
  return all;
}
inline bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
inline bool same(const scene::Joint& a, const scene::Joint& b) {
  return a.type == b.type && same(a.axis, b.axis) && same(a.point_mm, b.point_mm) && same(a.min, b.min) &&
         same(a.max, b.max) && same(a.stiffness, b.stiffness) && same(a.rest, b.rest);
}
inline bool same(const scene::VirtualManipulator& a, const scene::VirtualManipulator& b) {
  bool all = a.joints.size() == b.joints.size() && a.orientation == b.orientation && a.force_law == b.force_law &&
             same(a.ko_N_mm_per_rad, b.ko_N_mm_per_rad) && a.solver == b.solver &&
             std::memcmp(a.X_WV_home.data(), b.X_WV_home.data(), 16 * sizeof(double)) == 0;
  for (std::size_t i = 0; all && i < a.joints.size(); ++i) all = same(a.joints[i], b.joints[i]);
  return all;
}
/// As the file says them; what was loaded does not count.
inline bool same(const scene::Mesh& a, const scene::Mesh& b) {
  return a.file == b.file && a.checksum == b.checksum && same(a.scale_mm_per_unit, b.scale_mm_per_unit) &&
         a.search == b.search && same(a.smooth_deg, b.smooth_deg) &&
         std::memcmp(a.X_WM.data(), b.X_WM.data(), 16 * sizeof(double)) == 0;
}
inline bool same(const scene::Curve& a, const scene::Curve& b) {
  return a.file == b.file && same(a.scale_mm_per_unit, b.scale_mm_per_unit) && a.kind == b.kind &&
         a.closed == b.closed && a.search == b.search && a.guide == b.guide &&
         std::memcmp(a.X_WM.data(), b.X_WM.data(), 16 * sizeof(double)) == 0;
}
inline bool same(const scene::Shape& a, const scene::Shape& b) {
  return a.index() == b.index() &&
         std::visit([&](const auto& shape) { return same(shape, std::get<std::decay_t<decltype(shape)>>(b)); }, a);
}
inline bool same(const scene::Control& a, const scene::Control& b) {
  return a.law == b.law && a.anisotropy == b.anisotropy && same(a.gains.kp_N_per_mm, b.gains.kp_N_per_mm) &&
         same(a.gains.kd_N_s_per_mm, b.gains.kd_N_s_per_mm) && same(a.gains.ki_N_per_mm_s, b.gains.ki_N_per_mm_s);
}
inline bool same(const scene::Constraint& a, const scene::Constraint& b) {
  return a.name == b.name && same(a.shape, b.shape) && a.side == b.side && a.friction == b.friction &&
         a.control.has_value() == b.control.has_value() && (!a.control || same(*a.control, *b.control));
}
/// All but where it was read from.
inline bool same(const scene::Description& a, const scene::Description& b) {
  bool all = a.title == b.title && a.about == b.about && a.arm == b.arm && same(a.control, b.control) &&
             a.combine == b.combine && a.simulation == b.simulation && a.constraints.size() == b.constraints.size();
  for (std::size_t i = 0; all && i < a.constraints.size(); ++i) all = same(a.constraints[i], b.constraints[i]);
  return all;
}

/// One of each shape of plain numbers, each number by fill(meaning, number).
template <class Fill>
std::vector<scene::Shape> plainShapes(const Fill& fill) {
  std::vector<scene::Shape> all;
  scene::eachShape([&]<class Shape>(Shape shape) {
    eachField(shape, [&](const auto& field, auto& number) { fill(field.meaning, number); });
    if constexpr (scene::PlainShape<Shape>) all.emplace_back(std::move(shape));
  });
  return all;
}
/// About the origin, lengths of 60, 50 and 40 mm.
struct FillSizes {
  void operator()(scene::Meaning, double& number) const { number = 50.0; }
  void operator()(scene::Meaning, Mat3&) const {}
  void operator()(scene::Meaning meaning, Vec3& number) const {
    if (meaning == scene::Meaning::Length) number = {60.0, 50.0, 40.0};
  }
};

}  // namespace underact::test
