#include "core/registration/sheet.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "core/registration/fit.h"

namespace underact::registration {
namespace {

struct Mark {
  double right_mm, away_mm;
};

// Within 120 x 80 mm, which the tip of an Omni reaches (its workspace is 160 x 120 x 70 mm), and mostly at the rim: the
// further apart, the less an error rotates.
constexpr std::array<Mark, kMaxMarks> kMarks{
    {{0, 0}, {120, 0}, {0, 80}, {120, 60}, {70, 80}, {50, 0}, {0, 30}, {90, 30}}};

}  // namespace

std::vector<Vec3> sheetPoints(std::size_t count) {
  std::vector<Vec3> points_D;
  for (std::size_t at = 0; at < std::clamp(count, kFewestMarks, kMaxMarks); ++at)
    points_D.push_back(
        onDesk(kMetrePerMillimetre * kMarks[at].right_mm, kMetrePerMillimetre * kMarks[at].away_mm, 0.0));
  return points_D;
}

Vec3 onDesk(double right_m, double away_m, double up_m) {
  return {right_m, up_m, 0.0 - away_m};
}

double rightOf(const Vec3& p_D) {
  return p_D.x();
}

double awayOf(const Vec3& p_D) {
  return 0.0 - p_D.z();
}

double upOf(const Vec3& p_D) {
  return p_D.y();
}

}  // namespace underact::registration
