#include <algorithm>
#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/register_report.h"
#include "app/cli/scene_file.h"
#include "app/cli/step_report.h"
#include "app/cli/today.h"
#include "core/base/units.h"
#include "core/curve/points.h"
#include "core/registration/check.h"
#include "core/registration/registration_store.h"
#include "core/registration/sheet.h"
#include "core/system/signals.h"
#include "device/arm_key.h"
#include "device/catalogue.h"
#include "device/touch_reference_points.h"
#include "underact/version.h"

namespace underact::cli {
namespace {

using registration::Registration;
using registration::Touch;

struct RegisterOptions {
  std::string marks = "3", points, device, of, out;
  std::string arm{arm::kDefaultArm};
  double wait_s = 120.0;
  bool keep = false, json = false;
  bool accuracy = false;
  int draws = 20'000;
  std::uint64_t seed = 1;
};

bool isCount(const std::string& marks) {
  return marks.size() == 1 && marks[0] >= '0' + static_cast<char>(registration::kFewestMarks) &&
         marks[0] <= '0' + static_cast<char>(registration::kMaxMarks);
}

Result<std::vector<Vec3>> referencePointsOf(const std::string& marks) {
  if (isCount(marks)) return registration::sheetPoints(static_cast<std::size_t>(marks[0] - '0'));
  const Result<std::vector<Vec3>> read = curve::readPoints(marks);
  if (!read) return read.problems();
  std::vector<Vec3> points_D;
  for (const Vec3& mark_mm : read.value()) {
    const Vec3 mark_m = kMetrePerMillimetre * mark_mm;
    points_D.push_back(registration::onDesk(mark_m[0], mark_m[1], mark_m[2]));
  }
  return points_D;
}

/// From a file: of points, or of a registration.
Result<Registration> fromFile(const RegisterOptions& options) {
  if (options.points.ends_with(".json")) return registration::readRegistrationFile(options.points);
  const Result<std::vector<Vec3>> points_D = referencePointsOf(options.marks),
                                  points_mm = curve::readPoints(options.points);
  Problems problems = points_D ? Problems{} : points_D.problems();
  if (!points_mm) problems.insert(problems.end(), points_mm.problems().begin(), points_mm.problems().end());
  if (!problems.empty()) return problems;
  if (points_D.value().size() != points_mm.value().size()) {
    return Problems{{"There are " + std::to_string(points_D.value().size()) + " reference points and " +
                         std::to_string(points_mm.value().size()) +
                         " touched points. Give one line per reference point, in order.",
                     {options.points, 1, 1}}};
  }
  Registration registration;
  for (std::size_t at = 0; at < points_D.value().size(); ++at)
    registration.touches.push_back({points_D.value()[at], kMetrePerMillimetre * points_mm.value()[at], 0.0});
  return registration;
}

/// From an arm that a person moves.
Result<Registration> fromArm(const RegisterOptions& options, const Streams& streams, Exit& wrong) {
  constexpr int kRate_hz = 1000;
  const Result<std::vector<Vec3>> points_D = referencePointsOf(options.marks);
  if (!points_D) return points_D.problems();
  const arm::Preset& preset = *arm::findPreset(options.arm);
  wrong = Exit::Fault;
  Result<std::unique_ptr<servo::DevicePort>> arm = device::openDevice(options.device, {preset, {}, kRate_hz, {}});
  if (!arm) return arm.problems();
  Registration registration;
  registration.arm = device::armKey(options.device, arm.value()->info());
  const system::Interrupt interrupt(system::Reader::MayGo);
  streams.err << "No force is sent. Touch the reference points in the order of their numbers.\n";
  Result<std::vector<Touch>> touches =
      device::touchReferencePoints(std::move(arm).value(), preset, kRate_hz, points_D.value(),
                                   {[&streams](const std::string& sentence) { streams.err << sentence << std::endl; },
                                    [&interrupt] { return !interrupt.came(); }, options.wait_s});
  if (!touches) return touches.problems();
  wrong = Exit::BadInput;
  registration.touches = std::move(touches).value();
  return registration;
}

/// Whether it would mislead: then it is not saved.
bool isWrong(const std::vector<registration::Warning>& warnings) {
  return std::any_of(warnings.begin(), warnings.end(), [](const registration::Warning& one) {
    return one.kind == registration::Warning::Kind::Order || one.kind == registration::Warning::Kind::Residual;
  });
}

Exit keepIt(const RegisterOptions& options, const Registration& registration, const Streams& streams) {
  Problems problems;
  if (!options.out.empty()) problems = writeText(options.out, registrationText(registration));
  if (options.keep) {
    const Problems more = registration::saveRegistration(registration, registration::registrationFolder());
    problems.insert(problems.end(), more.begin(), more.end());
  }
  print(problems, streams.err);
  return problems.empty() ? Exit::Success : Exit::File;
}

Exit runRegistration(const RegisterOptions& options, const Streams& streams) {
  Exit wrong = Exit::BadInput;
  Result<Registration> touched = options.device.empty() ? fromFile(options) : fromArm(options, streams, wrong);
  if (!touched) {
    print(touched.problems(), streams.err);
    return wrong == Exit::Fault ? wrong : exitOf(touched.problems());
  }
  Registration registration = std::move(touched).value();
  const Result<registration::Fit> fit = fitTouches(registration.touches);
  if (!fit) return fail(fit.problems(), Exit::BadInput, streams);
  registration.fit = fit.value();
  if (!options.of.empty()) registration.arm = options.of;
  if (registration.date.empty()) registration.date = today();
  if (registration.program.empty()) registration.program = std::string("underact ") + kVersion;
  const std::vector<registration::Warning> warnings = warningsOf(registration.touches, registration.fit);
  if (options.json)
    streams.out << registrationObject(registration, warnings).text() << '\n';
  else
    printRegistration(registration, streams.out);
  for (const registration::Warning& warning : warnings) streams.err << warning.sentence << '\n';
  if (isWrong(warnings)) {
    if (options.keep || !options.out.empty()) streams.err << "It was not saved.\n";
    return Exit::BadInput;
  }
  if (options.keep && registration.arm.empty()) {
    streams.err << "--keep: name the arm with --of, as in --of wooden:0042.\n";
    return Exit::Usage;
  }
  return keepIt(options, registration, streams);
}

}  // namespace

void addRegister(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add(
      "register", "The pose of an arm on the desk, from reference points that its tip touches, and its accuracy");
  const auto options = std::make_shared<RegisterOptions>();
  command
      .option("--marks", options->marks,
              "3 to 8 reference points of the printed sheet, or a file: one line per reference point, mm to the right, "
              "away from you, up")
      .showDefault();
  const Option points = command.option(
      "--points", options->points,
      "A file of the touched points: one line per reference point, x, y and z in W, mm; or a registration (.json)");
  const Option device =
      command.option("--device", options->device, "Touch them now with the arm KIND or KIND:ADDRESS, without force");
  const Option accuracy =
      command.flag("--accuracy", options->accuracy, "The registration error that results from errors of touching");
  points.excludes(device).excludes(accuracy);
  device.excludes(accuracy);
  command.option("--of", options->of, "The arm it belongs to, if --device does not say so");
  std::vector<std::string> arms;
  for (const arm::Preset& preset : arm::presets()) arms.push_back(preset.name);
  command.option("--arm", options->arm, "Geometry of the arm that touches them")
      .needs(device)
      .showDefault()
      .oneOf(arms);
  command.option("--out", options->out, "Write the registration to this file");
  command.flag("--keep", options->keep, "Save it for its arm, where the window finds it");
  command.option("--wait_s", options->wait_s, "Time to wait for each press, s")
      .needs(device)
      .range(0.1, 3600.0)
      .showDefault();
  command.option("--draws", options->draws, "Number of simulated registrations per row")
      .needs(accuracy)
      .range(10, 10'000'000)
      .showDefault();
  command.option("--seed", options->seed, "Seed of the simulated registrations").needs(accuracy).showDefault();
  command.flag("--json", options->json, "JSON instead of the table");
  command.footer(
      "Touch the reference points in the order of their numbers. Exit status 1 if they were touched in another order, "
      "or one\n"
      "of them far from its position: nothing is saved then.");
  command.whenChosen([options, &streams, &exit] {
    if (options->accuracy) {
      printAccuracy(options->draws, options->seed, options->json, streams.out);
      return;
    }
    if (options->points.empty() && options->device.empty())
      options::refuse("register: give --points, --device or --accuracy");
    exit = runRegistration(*options, streams);
  });
}

}  // namespace underact::cli
