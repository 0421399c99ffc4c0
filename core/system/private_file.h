#pragma once
#include <string>

#include "core/base/result.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// What to do with an existing file of the same name. Replace: a link, too, and not its target. ReplaceFile: a file
/// alone, whose rights the new one gets; for an export, which nobody asked whether it may.
enum class Existing { Refuse, Replace, ReplaceFile };

/// Whether a new file may be made at path; changes nothing. Problems: with Refuse an existing file, with it or
/// ReplaceFile a link, even a dangling one; a folder, a pipe or a device, which are never replaced.
Problems checkNew(const std::string& path, Existing existing);

/// Makes a new file at path, open for reading and writing, for its owner alone, whatever the umask; never an existing
/// one: a file or a link of that name that may be replaced is removed first, and the target of a link stays. So nothing
/// is ever written through a link, and no pipe is waited for. None on failure: errno says why, EEXIST that there is
/// one.
Descriptor makeNew(const std::string& path, Existing existing);

/// Makes a folder and its missing parents, each for its owner alone, whatever the umask. An existing one stays as it
/// is. 0, or the system's error number.
int makePrivateFolder(const std::string& path);

}  // namespace underact::system
