#pragma once
#include <string>

#include "core/base/result.h"
#include "core/system/descriptor.h"

namespace underact::system {

/// What is done where there is something of the name already.
enum class Existing { Refuse, Replace };

/// Whether a new file may be made at path. Problems: Refuse and there is a file or a link, also one that leads nowhere;
/// a folder, a pipe or a device, which are never replaced. Touches nothing.
Problems checkNew(const std::string& path, Existing existing);

/// A file of its own at path, open for reading and writing, which its owner alone may read and write, whatever the
/// umask is; never what stood there: with Replace a file or a link of that name is taken away first, and what a link
/// led to stays. None where that fails: errno says why, and EEXIST that somebody was quicker.
Descriptor makeNew(const std::string& path, Existing existing);

/// Makes a folder and those above it that are missing; into each that is made its owner alone can look, whatever the
/// umask is. One that is there stays as it is. 0, or the system's reason.
int makePrivateFolder(const std::string& path);

}  // namespace underact::system
