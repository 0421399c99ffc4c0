#include "core/mesh_file/read_file.h"

#include "core/base/translate.h"
#include "core/helper/run.h"
#include "core/mesh_file/limits.h"
#include "core/mesh_file/message.h"
#include "core/system/resource_paths.h"

namespace underact::mesh_file {
namespace {

constexpr const char* kReader = "underact-mesh-reader";

/// The reason why there is no mesh; empty: there is an answer.
Sentence noneReason(const helper::Answer& answer, const helper::HelperCall& errand) {
  using helper::Ending;
  switch (answer.ending) {
    case Ending::Exited:
      return answer.code == 0
                 ? Sentence()
                 : phrase(TRANSLATE_NOOP("problem", "The file cannot be read: the reader program exited with %1."),
                          {std::to_string(answer.code)});
    case Ending::Crashed:
      return phrase(TRANSLATE_NOOP("problem", "The file is damaged: the reader program crashed (signal %1)."),
                    {std::to_string(answer.code)});
    case Ending::TookTooLong:
      return phrase(TRANSLATE_NOOP("problem",
                                   "The file is damaged, or has very large faces: reading it took longer than %1, "
                                   "which is enough for a file of its size."),
                    {helper::secondsText(errand.max_cpu_s)});
    case Ending::Waited:
      return helper::timeoutText(errand.max_time_s);
    case Ending::WroteTooMuch:
      return phrase(
          TRANSLATE_NOOP("problem", "The file is damaged: it declares more faces than a file of its size can hold."));
    case Ending::Cancelled:
      return kCancelled;
    case Ending::NotStarted:
    case Ending::NotSandboxed:
      return helper::helperFailureText(answer.ending, kReader, answer.code);
  }
  return {};
}

}  // namespace

Result<RawMesh> readFile(const Input& input, const TaskMonitor& monitor) {
  const auto problem = [&](const Sentence& sentence) { return Problems{{sentence, {input.path()}}}; };
  const Result<std::string> reader = system::findProgram(kReader, "UNDERACT_MESH_READER");
  if (!reader)
    return problem(oneAfterAnother({reader.problems().front().sentence,
                                    phrase(TRANSLATE_NOOP("problem", "It reads meshes: reinstall Underact."))}));
  helper::HelperCall errand;
  errand.program = reader.value();
  errand.argument = wordOf(input.format());
  errand.input_fd = input.rewound();
  errand.max_cpu_s = maxCpu_s(input.bytes());
  errand.max_time_s = maxTime_s(input.bytes());
  errand.max_output = maxMemory(input.bytes());
  errand.progress = [&monitor](unsigned char percent) {
    monitor.report(TRANSLATE_NOOP("step of work", "Reading the mesh"), percent / 100.0);
  };
  const helper::Answer answer = run(errand, monitor);
  const Sentence why = noneReason(answer, errand);
  if (!why.empty()) return problem(why);
  std::optional<Message> message = readMessage(answer.output);
  if (!message)
    return problem(
        phrase(TRANSLATE_NOOP("problem", "The file is damaged: the reader program could not make a mesh of it.")));
  if (!message->problem.empty()) return problem(message->problem);
  if (input.hasChanged())
    return problem(phrase(TRANSLATE_NOOP("problem", "The file changed while it was being read. Open it again.")));
  message->raw.cpu_s = answer.cpu_s;
  return std::move(message->raw);
}

Result<RawMesh> readFile(const std::string& path, const TaskMonitor& monitor) {
  const Result<Input> input = Input::open(path);
  if (!input) return input.problems();
  return readFile(input.value(), monitor);
}

}  // namespace underact::mesh_file
