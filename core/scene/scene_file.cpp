#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/base/translate.h"
#include "core/json/text.h"
#include "core/scene/read.h"
#include "core/scene/write.h"
#include "core/system/file.h"
#include "core/system/this_process.h"

namespace underact::scene {
namespace {

std::string wordsOf(int reason) {
  return std::generic_category().message(reason);
}

Problems problem(const std::string& path, Sentence sentence) {
  return {{std::move(sentence), {path, 0, 0, ""}}};
}

/// The target of a link at path, so that the link stays a link.
std::string withoutLinks(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

}  // namespace

Result<Description> readSceneFile(const std::string& path) {
  const Result<std::string> text = json::readTextFile(path, phrase(TRANSLATE_NOOP("problem", "a scene")));
  if (!text) return text.problems();
  return readScene(text.value(), path);
}

Problems writeSceneFile(const Description& scene, const std::string& path, const std::optional<Teaching>& teaching) {
  const std::string target = withoutLinks(path);
  const std::string part = target + "." + system::uniqueWord() + ".part";
  const std::optional<system::Status> old = system::statusOf(target);
  if (old && old->kind == system::FileKind::Folder)
    return problem(path, phrase(TRANSLATE_NOOP("problem", "This is a folder; a scene needs a file name.")));
  system::Descriptor file = system::makeFile(part, system::Making::Emptied, system::Readers::Default);
  if (!file.isOpen())
    return problem(path, phrase(TRANSLATE_NOOP("problem", "The scene cannot be saved: %1."), {wordsOf(errno)}));
  if (old) (void)system::setRights(file.number(), old->rights);
  const int reason =
      system::putInPlace(std::move(file), part, target, writeScene(scene, teaching), system::Lasting::OnDisk);
  if (reason != 0)
    return problem(path,
                   phrase(TRANSLATE_NOOP("problem", "The scene cannot be saved: %1. The existing file is unchanged."),
                          {wordsOf(reason)}));
  return {};
}

}  // namespace underact::scene
