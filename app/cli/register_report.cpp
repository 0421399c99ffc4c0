#include "app/cli/register_report.h"

#include <array>
#include <cstdio>
#include <ostream>
#include <string>

#include "app/cli/table.h"
#include "core/base/units.h"
#include "core/registration/accuracy.h"
#include "core/registration/error.h"
#include "core/registration/sheet.h"

namespace underact::cli {
namespace {

using registration::awayOf;
using registration::Registration;
using registration::rightOf;
using registration::Touch;
using registration::upOf;

constexpr std::array<std::pair<registration::Warning::Kind, const char*>, 6> kKinds{
    {{registration::Warning::Kind::NearLine, "near_line"},
     {registration::Warning::Kind::NearMarks, "near_marks"},
     {registration::Warning::Kind::Order, "order"},
     {registration::Warning::Kind::UpsideDown, "upside_down"},
     {registration::Warning::Kind::Residual, "residual"},
     {registration::Warning::Kind::Moved, "moved"}}};

double mm(double length_m) {
  return length_m * kMillimetrePerMetre;
}

JsonObject warningObject(const registration::Warning& warning) {
  JsonObject object;
  for (const auto& [kind, name] : kKinds) {
    if (kind == warning.kind) object.addText("kind", name);
  }
  object.addText("sentence", warning.sentence);
  std::vector<double> marks;
  for (const std::size_t mark : warning.marks) marks.push_back(static_cast<double>(mark + 1));
  object.addList("marks", marks);
  return object;
}

std::string line(const char* format, double value) {
  char text[160];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

JsonObject registrationObject(const Registration& registration, const std::vector<registration::Warning>& warnings) {
  JsonObject object;
  registration.arm.empty() ? object.addNull("arm") : object.addText("arm", registration.arm);
  Eigen::MatrixXd X_DW = registration.fit.X_DW.matrix();
  X_DW.topRightCorner(3, 1) *= kMillimetrePerMetre;
  object.addMatrix("X_DW", X_DW);
  std::vector<double> residuals_mm;
  for (const Vec3& off : registration.fit.off_D) residuals_mm.push_back(mm(off.norm()));
  object.addList("residuals_mm", residuals_mm);
  object.addNumber("rms_mm", mm(registration.fit.rms_m));
  const registration::ErrorInTheMiddle middle = errorInTheMiddle(registration.touches, registration.fit);
  object.addNumber("expected_mm", mm(middle.expected_m));
  object.addNumber("likely_most_mm", mm(middle.likely_max_m));
  std::vector<JsonObject> told;
  for (const registration::Warning& warning : warnings) told.push_back(warningObject(warning));
  object.addList("warnings", told);
  return object;
}

void printRegistration(const Registration& registration, std::ostream& out) {
  Table table({"mark", "right_mm", "away_mm", "up_mm", "x_mm", "y_mm", "z_mm", "residual_mm", "spread_mm"});
  for (std::size_t at = 0; at < registration.touches.size(); ++at) {
    const Touch& touch = registration.touches[at];
    table.add({static_cast<std::int64_t>(at + 1), mm(rightOf(touch.p_DM)), mm(awayOf(touch.p_DM)), mm(upOf(touch.p_DM)),
               mm(touch.p_WM.x()), mm(touch.p_WM.y()), mm(touch.p_WM.z()), mm(registration.fit.off_D[at].norm()),
               mm(touch.spread_m)});
  }
  table.printText(out);
  const registration::ErrorInTheMiddle middle = errorInTheMiddle(registration.touches, registration.fit);
  out << line("Distance of the points from their reference points: %.2f mm (root mean square)\n",
              mm(registration.fit.rms_m))
      << line("Expected error in the middle of the workspace: %.2f mm", mm(middle.expected_m))
      << line(", in 19 of 20 registrations at most %.2f mm\n", mm(middle.likely_max_m));
}

void printAccuracy(int draws, std::uint64_t seed, bool json, std::ostream& out) {
  Table table({"marks", "touching_mm", "left_mm", "expected_mm", "seen_mm", "twentieth_mm"});
  for (const std::size_t marks : {3U, 4U, 6U, 8U}) {
    for (const double touching_m : {0.1e-3, 0.2e-3, 0.5e-3, 1.0e-3}) {
      const registration::Accuracy row =
          registration::accuracyOf(registration::sheetPoints(marks), touching_m, draws, seed);
      table.add({static_cast<std::int64_t>(row.marks), mm(row.touching_m), mm(row.left_m), mm(row.expected_m),
                 mm(row.seen_m), mm(row.twentieth_m)});
    }
  }
  json ? table.printJson(out) : table.printText(out);
}

}  // namespace underact::cli
