#include <memory>
#include <ostream>

#include "app/cli/arm_choice.h"
#include "app/cli/scene_file.h"
#include "core/arm/arm_text.h"
#include "core/arm/solid_place.h"

namespace underact::cli {
namespace {

struct ConvertOptions {
  std::string in, to;
  arm::UrdfEnds ends;
};

Exit convert(const ConvertOptions& options, const Streams& streams) {
  const Result<kinematics::SolvedArm> arm = kinematics::chooseArm(options.in, options.ends);
  if (!arm) return refuseArm(arm.problems(), streams.err);
  const arm::ArmForm to = options.to == "urdf"  ? arm::ArmForm::Urdf
                          : options.to == "poe" ? arm::ArmForm::Exponentials
                                                : arm::ArmForm::ModifiedDh;
  const Result<std::string> text = arm::textOf(arm.value().model, to);
  if (!text) return fail(text.problems(), Exit::BadInput, streams);
  streams.out << text.value();
  printNotes(arm::solidProblems(arm.value().model), streams.err);
  return Exit::Success;
}

}  // namespace

void addArm(Command program, const Streams& streams, Exit& exit) {
  const Command arm = program.add("arm", "Arm files");
  arm.mustChoose();
  const Command command = arm.add("convert", "Write an arm in another form");
  const auto options = std::make_shared<ConvertOptions>();
  command.option("arm", options->in, "An arm from the list below, an arm file, or a URDF file").required();
  command
      .option("--to", options->to,
              "dh: a table in modified convention; poe: a product of exponentials; urdf: for other programs")
      .oneOf({"dh", "poe", "urdf"})
      .required();
  addEndOptions(command, options->ends);
  command.footer("The new file is printed. The frame of the base of a URDF file becomes the workspace's.\n\n" +
                 listOfArms());
  command.whenChosen([options, &streams, &exit] { exit = convert(*options, streams); });
}

}  // namespace underact::cli
