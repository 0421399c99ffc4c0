#pragma once
#include <cstddef>
#include <span>

#include "core/system/descriptor.h"

// What goes from one process, or thread, to another. Reasons are left in errno.
namespace underact::system {

/// The two ends of a pipe.
struct Pipe {
  Descriptor reads, writes;  // none where there is none
};
/// most_bytes: that it holds unread, as far as the system grants that; 0: as usual.
Pipe makePipe(std::size_t most_bytes = 0);

/// Two ends that know each other alone, each for both directions. Where the other end is gone, no signal comes.
struct Line {
  Descriptor here, there;
};
/// Both ends closed (isOpen() false) where the system refuses.
Line makeLine();

/// The first of them that there is something to read from, or that has ended; below 0: none within time_ms. Numbers
/// below 0 are passed over.
int waitForAny(std::span<const int> descriptors, int time_ms);
/// Whether there is something to read, or the other end has closed, within time_ms; below 0: as long as it takes.
/// false, too, where a signal ended the wait.
bool waitToRead(int descriptor, int time_ms);
/// The same for something that can be written.
bool waitToWrite(int descriptor, int time_ms);

/// How many bytes went, as far as they go at once; 0: it has ended; below 0: it failed, and EAGAIN says not now.
std::ptrdiff_t readSome(int descriptor, std::span<std::byte> into);
/// How many bytes were taken; below 0: it failed, and EAGAIN says not now.
std::ptrdiff_t writeSome(int descriptor, std::span<const char> bytes);
/// The same of an end of a Line, never waiting.
std::ptrdiff_t receiveSome(int end, std::span<std::byte> into);
/// As writeSome() for an end of a Line, never waiting; where the other end is gone, EPIPE and no signal.
std::ptrdiff_t sendSome(int end, std::span<const std::byte> bytes);

}  // namespace underact::system
