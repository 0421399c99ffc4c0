#include <cerrno>
#include <system_error>

#include "core/base/translate.h"
#include "core/record/untrusted_file.h"
#include "core/system/file.h"

namespace underact::record {
namespace {

Problems openFailureReason(const std::string& path, int error) {
  if (error == ENOENT || error == ENOTDIR)
    return {{phrase(TRANSLATE_NOOP("problem", "There is no such file.")), {path}}};
  if (error == ELOOP)
    return {
        {phrase(TRANSLATE_NOOP(
             "problem", "This is a link to another file, which would be changed instead. Give the name of that file.")),
         {path}}};
  return {
      {phrase(TRANSLATE_NOOP("problem", "The file cannot be opened: %1."), {std::generic_category().message(error)}),
       {path}}};
}

}  // namespace

Result<UntrustedInput> UntrustedInput::open(const std::string& path, bool follows) {
  system::Descriptor opened = system::openToRead(path, follows ? system::Links::Follow : system::Links::Refuse);
  const std::optional<system::Status> file = opened.isOpen() ? system::statusOf(opened.number()) : std::nullopt;
  if (!file) return openFailureReason(path, errno);
  if (file->kind == system::FileKind::Folder)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "This is a folder, not a session.")), {path}}};
  if (file->kind != system::FileKind::File)
    return Problems{{phrase(TRANSLATE_NOOP("problem", "This is not a session file.")), {path}}};
  if (!system::lock(opened.number(), system::Lock::Shared))
    return Problems{
        {phrase(TRANSLATE_NOOP("problem", "Another program has this file open. Close it there first.")), {path}}};
  return UntrustedInput(path, std::move(opened));
}

std::int64_t UntrustedInput::bytes() const {
  const std::optional<system::Status> file = system::statusOf(fd());
  return file ? static_cast<std::int64_t>(file->bytes) : 0;
}

void UntrustedInput::unlock() const {
  system::unlock(fd());
}

}  // namespace underact::record
