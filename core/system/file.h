#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/system/descriptor.h"

// Files as the system has them. What gives a descriptor, a status or a number of bytes leaves the system's reason in
// errno where it gives none; what gives an int gives 0 or that reason.
namespace underact::system {

/// Of a file, a pipe or a socket, in one go: kernels that do not preempt themselves let nobody run on that processor
/// before a read is done, not even the servo. Of 38 MB at once that was 6 ms.
inline constexpr std::size_t kAtOnce = std::size_t{1} << 18;

/// Whether a link at the path is followed, or is a reason not to open it.
enum class Links : std::uint8_t { Follow, Refuse };

/// For reading. Waits for no writer of a pipe, and takes no terminal.
Descriptor openToRead(const std::string& path, Links links = Links::Follow);

/// For writing, what is there.
Descriptor openToWrite(const std::string& path);

/// New: nothing may have the name, not even a link that leads nowhere. Emptied: what is there loses what it holds.
/// Further: what is there stays, and each write goes to its end.
enum class Making : std::uint8_t { New, Emptied, Further };
/// Whom the umask lets; or its owner, whatever that is.
enum class Readers : std::uint8_t { AsUsual, OwnerAlone };

/// For writing, and but for Emptied for reading, too.
Descriptor makeFile(const std::string& path, Making making, Readers readers);
/// A folder that its owner alone may enter; its parent is there.
int makeOwnersFolder(const std::string& path);

/// What has a name in a folder.
enum class Kind : std::uint8_t { File, Folder, Link, Other };

/// What the system says of a file.
struct Status {
  Kind kind = Kind::Other;
  std::uint64_t bytes = 0;
  std::int64_t changed_ns = 0;
  std::uint64_t disk = 0, number = 0;  // no two files that are there have both in common
  unsigned rights = 0;                 // as chmod has them
  bool is_trusted = false;             // it belongs to this user or to the system
};
/// Links::Refuse: of a link, the link's own.
std::optional<Status> statusOf(const std::string& path, Links links = Links::Follow);
std::optional<Status> statusOf(int descriptor);
/// Whether both are there, and are one file.
bool areTheSame(const std::optional<Status>& one, const std::optional<Status>& other);
/// rights: as chmod has them.
int setRights(int descriptor, unsigned rights);
/// Whether this user may. What is not there: false.
bool mayReadAndWrite(const std::string& path);
/// Whether this user may run it. What is not there: false.
bool mayExecute(const std::string& path);

/// A name that opens just this file, whatever has come to stand at its path; path where the system has no such names.
std::string nameOf(int descriptor, const std::string& path);

/// Fills into, or up to the end; gives how many bytes.
std::optional<std::size_t> readAll(int descriptor, std::span<std::byte> into);
/// The same from a place on, which the next read does not move.
std::optional<std::size_t> readAllAt(int descriptor, std::uint64_t from, std::span<std::byte> into);
/// Where nothing more goes in, the disk is full.
int writeAll(int descriptor, std::span<const std::byte> bytes);
/// The next read or write is at its beginning.
void rewind(int descriptor);
/// Where the file ends; 0 where that is unknown. By the one system call that a sealed process may make for it.
std::int64_t lengthOf(int descriptor);
/// Makes the file this long; where it was shorter, zeros are added.
int cutTo(int descriptor, std::uint64_t bytes);
/// On the disk, also after a power cut.
int sync(int descriptor);
/// The same of the names in the folder of a file; what a file system cannot do is left.
void syncFolderOf(const std::string& path);

/// Shared: several may hold it at once. Alone: nobody else may.
enum class Lock : std::uint8_t { Shared, Alone };
/// false: somebody else holds it. Until all copies of the descriptor are closed. A file system without locks has none.
bool lock(int descriptor, Lock how);
/// Gives the lock back; none held: nothing happens.
void unlock(int descriptor);

/// Whether room was set aside. Unknown: the file system cannot. None: the disk is full.
enum class Room : std::uint8_t { SetAside, Unknown, None };
/// On the disk, from the file's byte `from` on, without changing its length.
Room setAside(int descriptor, std::int64_t from, std::int64_t bytes);

/// What is written to it from now on goes nowhere.
void leadNowhere(int descriptor);

/// To write through. null: none; then the descriptor is closed.
std::FILE* streamOf(Descriptor descriptor);

/// from gets the name `to`, if nothing has it.
int renameIfFree(const std::string& from, const std::string& to);

/// OnDisk: also after a power cut, see sync().
enum class Lasting : std::uint8_t { Written, OnDisk };
/// made, a new file at part, gets the text and then path for its name; or what is at path stays, and part is gone.
int putInPlace(Descriptor made, const std::string& part, const std::string& path, std::string_view text, Lasting how);

}  // namespace underact::system
