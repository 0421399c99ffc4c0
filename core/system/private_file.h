#pragma once
#include <string>

#include "core/base/result.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// What to do with an existing file of the same name.
enum class Existing { Refuse, Replace };

/// Whether a new file may be made at path; changes nothing. Problems: with Refuse an existing file or link, even a
/// dangling one; a folder, a pipe or a device, which are never replaced.
Problems checkNew(const std::string& path, Existing existing);

/// Makes a new file at path, open for reading and writing, for its owner alone, whatever the umask; never an existing
/// one: with Replace a file or a link of that name is removed first, and the target of a link stays. None on failure:
/// errno says why, EEXIST that another process was quicker.
Descriptor makeNew(const std::string& path, Existing existing);

/// Makes a folder and its missing parents, each for its owner alone, whatever the umask. An existing one stays as it
/// is. 0, or the system's error number.
int makePrivateFolder(const std::string& path);

}  // namespace underact::system
