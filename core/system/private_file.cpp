#include "core/system/private_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "core/base/translate.h"
#include "core/system/file.h"

namespace underact::system {
namespace {

bool mayBeReplaced(const Status& there, Existing existing) {
  return there.kind == FileKind::File || (there.kind == FileKind::Link && existing != Existing::ReplaceFile);
}

}  // namespace

Problems checkNew(const std::string& path, Existing existing) {
  const std::optional<Status> there = statusOf(path, Links::Refuse);
  if (!there) return {};  // missing; any other problem shows when it is made
  if (existing == Existing::ReplaceFile && there->kind == FileKind::Link)
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "This is a link to another file, which would be changed instead. Give the name of "
                                   "that file.")),
             {path}}};
  if (!mayBeReplaced(*there, existing))
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "A folder, a pipe or a device has this name and is not replaced. Give another "
                                   "name.")),
             {path}}};
  if (existing != Existing::Refuse) return {};
  return {{phrase(TRANSLATE_NOOP(
               "problem", "A file or a link of this name already exists; it was left unchanged. Give another name.")),
           {path}}};
}

Descriptor makeNew(const std::string& path, Existing existing) {
  const std::optional<Status> there = statusOf(path, Links::Refuse);
  if (existing != Existing::Refuse && there && mayBeReplaced(*there, existing)) std::remove(path.c_str());
  Descriptor made = makeFile(path, Making::New, Readers::OwnerAlone);
  if (existing == Existing::ReplaceFile && there && made.isOpen()) (void)setRights(made.number(), there->rights);
  return made;
}

int makePrivateFolder(const std::string& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error).lexically_normal();
  if (error) return error.value();
  std::filesystem::path at;
  for (const std::filesystem::path& part : whole) {
    at /= part;
    const int reason = makeOwnersFolder(at.string());
    // It may exist already, also where nothing can be made.
    if (reason != 0 && !std::filesystem::is_directory(at, error)) return reason == EEXIST ? ENOTDIR : reason;
  }
  return 0;
}

}  // namespace underact::system
