#pragma once
#include <cstddef>
#include <span>

#include "core/system/descriptor.h"

// Communication between processes or threads. On failure, errno says why.
namespace underact::system {

/// The two ends of a pipe.
struct Pipe {
  Descriptor reads, writes;  // both none on failure
};
/// max_bytes: its capacity, as far as the system grants it; 0: the default.
Pipe makePipe(std::size_t max_bytes = 0);

/// A connected pair of ends, each for both directions. Writing to a closed end raises no signal.
struct Line {
  Descriptor here, there;
};
/// Both ends closed (isOpen() false) where the system refuses.
Line makeLine();

/// The index of the first descriptor that is readable or has ended; below 0: none within time_ms. Descriptors below 0
/// are ignored.
int waitForAny(std::span<const int> descriptors, int time_ms);
/// Whether there is something to read, or the other end has closed, within time_ms; below 0: as long as it takes.
/// false, too, where a signal ended the wait.
bool waitToRead(int descriptor, int time_ms);
/// Waits until something can be written.
bool waitToWrite(int descriptor, int time_ms);

/// Reads the bytes that are available; gives their number. 0: the end; below 0: failed, with EAGAIN where there are
/// none now.
std::ptrdiff_t readSome(int descriptor, std::span<std::byte> into);
/// Writes as many bytes as are accepted; gives their number. Below 0: failed, with EAGAIN where none are accepted now.
std::ptrdiff_t writeSome(int descriptor, std::span<const char> bytes);
/// readSome() for an end of a Line, never waiting.
std::ptrdiff_t receiveSome(int end, std::span<std::byte> into);
/// writeSome() for an end of a Line, never waiting; where the other end is closed, EPIPE and no signal.
std::ptrdiff_t sendSome(int end, std::span<const std::byte> bytes);

}  // namespace underact::system
