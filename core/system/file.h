#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/system/descriptor.h"

// Files by the operating system. A function that gives a descriptor, a status or a number of bytes leaves the reason of
// a failure in errno; one that gives an int gives 0 or that reason.
namespace underact::system {

/// Bytes read at once from a file, a pipe or a socket: a kernel without preemption lets nothing else run on that
/// processor before a read is done, not even the servo. For 38 MB at once that was 6 ms.
inline constexpr std::size_t kAtOnce = std::size_t{1} << 18;

/// Whether a link at the path is followed, or is a reason not to open it.
enum class Links : std::uint8_t { Follow, Refuse };

/// Opens for reading. Does not wait for a writer of a pipe, and never makes a terminal the controlling one.
Descriptor openToRead(const std::string& path, Links links = Links::Follow);

/// Opens an existing file for writing.
Descriptor openToWrite(const std::string& path);

/// New: the name must be free, even of a dangling link. Emptied: an existing file is emptied. Further: an existing file
/// stays, and each write appends.
enum class Making : std::uint8_t { New, Emptied, Further };
/// Who may read a new file: as the umask allows, or its owner alone in any case.
enum class Readers : std::uint8_t { Default, OwnerAlone };

/// Makes a file and opens it for writing, and, except for Emptied, for reading, too.
Descriptor makeFile(const std::string& path, Making making, Readers readers);
/// Makes a folder that its owner alone may enter; its parent exists.
int makeOwnersFolder(const std::string& path);

/// The kind of an entry of a folder.
enum class FileKind : std::uint8_t { File, Folder, Link, Other };

/// What the system says of a file.
struct Status {
  FileKind kind = FileKind::Other;
  std::uint64_t bytes = 0;
  std::int64_t changed_ns = 0;
  std::uint64_t disk = 0, number = 0;  // together unique among existing files
  unsigned rights = 0;                 // as chmod has them
  bool is_trusted = false;             // it belongs to this user or to the system
};
/// None where it does not exist. Links::Refuse: of a link itself.
std::optional<Status> statusOf(const std::string& path, Links links = Links::Follow);
std::optional<Status> statusOf(int descriptor);
/// Whether both exist and are the same file.
bool isSameFile(const std::optional<Status>& one, const std::optional<Status>& other);
/// rights: as chmod has them.
int setRights(int descriptor, unsigned rights);
/// Whether this user may read and write it; false where it does not exist.
bool mayReadAndWrite(const std::string& path);
/// Whether this user may run it; false where it does not exist.
bool mayExecute(const std::string& path);

/// A path that opens exactly this file, whatever is at its own path now; `path` where the system has no such names.
std::string nameOf(int descriptor, const std::string& path);

/// Reads until `into` is full or the file ends; gives the number of bytes.
std::optional<std::size_t> readAll(int descriptor, std::span<std::byte> into);
/// Reads from an offset, without moving the position of the next read.
std::optional<std::size_t> readAllAt(int descriptor, std::uint64_t from, std::span<std::byte> into);
/// Writes all bytes; a write that makes no progress counts as a full disk.
int writeAll(int descriptor, std::span<const std::byte> bytes);
/// The next read or write is at its beginning.
void rewind(int descriptor);
/// The length of the file; 0 where it is unknown. By the one system call for it that a sealed process may make.
std::int64_t lengthOf(int descriptor);
/// Copies all of a file into a new one, which has holes where it has them.
int copyContent(int from, int to);
/// Owner, as far as this user may, and rights as those of another file.
int setRightsLike(int descriptor, int model);
/// Makes the file this long; where it was shorter, zeros are added.
int cutTo(int descriptor, std::uint64_t bytes);
/// Waits until the file is on the disk, safe from a power cut.
int sync(int descriptor);
/// Syncs the names in the folder of a file, as far as the file system supports it.
void syncFolderOf(const std::string& path);

/// Shared: several may hold it at once. Alone: nobody else may.
enum class Lock : std::uint8_t { Shared, Alone };
/// Takes a lock, until all copies of the descriptor are closed. false: another process holds it. Without effect on a
/// file system without locks.
bool lock(int descriptor, Lock how);
/// Releases the lock; without effect where there is none.
void unlock(int descriptor);

/// Whether room was set aside. Unknown: the file system cannot. None: the disk is full.
enum class Room : std::uint8_t { DiskReserve, Unknown, None };
/// Reserves disk space from the file's byte `from` on, without changing its length.
Room setAside(int descriptor, std::int64_t from, std::int64_t bytes);

/// Discards everything that is written to it from now on.
void redirectToNull(int descriptor);

/// A stream for writing, which takes the descriptor over. Null: failed; then the descriptor is closed.
std::FILE* streamOf(Descriptor descriptor);

/// Renames a file, if the name `to` is free.
int renameIfFree(const std::string& from, const std::string& to);

/// OnDisk: also after a power cut, see sync().
enum class Lasting : std::uint8_t { Written, OnDisk };
/// Writes the text to `made`, a new file at part, and renames it to path; or, on failure, leaves path as it is and
/// removes part.
int putInPlace(Descriptor made, const std::string& part, const std::string& path, std::string_view text, Lasting how);

}  // namespace underact::system
