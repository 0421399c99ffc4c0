#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "core/chain/closed_form.h"
#include "tests/bench/kinematics/table.h"

namespace underact::bench {
namespace {

/// Axes, offsets from axis to axis (and on to the tip), the tip's turn at home, and the poses: lines of numbers.
void write(const Cases& cases, const std::string& path) {
  std::ofstream file(path);
  file.precision(17);
  for (const chain::Joint& joint : cases.chain.joints) file << joint.axis_W.transpose() << '\n';
  Vec3 p_WLast = Vec3::Zero();
  for (const chain::Joint& joint : cases.chain.joints) {
    file << (joint.p_WJ - p_WLast).transpose() << '\n';
    p_WLast = joint.p_WJ;
  }
  file << (cases.chain.X_WT_home.translation() - p_WLast).transpose() << '\n';
  const Eigen::IOFormat row(Eigen::FullPrecision, Eigen::DontAlignCols, " ", " ");
  file << cases.chain.X_WT_home.linear().format(row) << '\n';
  for (const Pose& X_WT : cases.X_WT) file << X_WT.matrix().format(row) << '\n';
}

std::string outputOf(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe != nullptr && std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

}  // namespace

Lines eaik(const Cases& cases) {
  if (cases.arm.rows.size() != 6) return {};  // it has no other joints
  Line line{cases.arm.name, "inverse, all branches", "EAIK"};
  const std::filesystem::path poses = std::filesystem::temp_directory_path() / ("underact_" + cases.arm.name + ".txt");
  write(cases, poses.string());
  const char* const asked = std::getenv("UNDERACT_PYTHON");
  const std::string python = asked != nullptr ? asked : "python3";
  std::istringstream words(outputOf("'" + python + "' '" UNDERACT_BENCH_SCRIPT "' '" + poses.string() + "'"));
  std::filesystem::remove(poses);
  std::string version;
  int answers = 0;
  if (words >> version >> line.median_ns >> answers >> line.success >> line.worst_m >> line.worst_rad) {
    line.note = std::to_string(answers) + " answers; " + version + ", through Python";
  } else {
    line.note = "not installed";
  }
  return {line};
}

}  // namespace underact::bench
