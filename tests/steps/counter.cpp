#include "tests/steps/counter.h"

#include <cstddef>

namespace {

constinit thread_local long done = 0;  // constant: a first touch in malloc must not itself allocate

void count(std::size_t bytes) {
  done += 1 + static_cast<long>(bytes / 8);
}

/// The first place below size where ends() is true, or size.
template <class Ends>
std::size_t placeOf(std::size_t size, const Ends& ends) {
  std::size_t at = 0;
  while (at < size && !ends(at)) ++at;
  count(at);
  return at;
}

}  // namespace

extern "C" {

using Byte = unsigned char;

void* __libc_malloc(std::size_t size);

void* malloc(std::size_t size) noexcept {
  count(size);
  return __libc_malloc(size);
}
int memcmp(const void* a, const void* b, std::size_t size) noexcept {
  const auto *const one = static_cast<const Byte*>(a), *const other = static_cast<const Byte*>(b);
  const std::size_t at = placeOf(size, [&](std::size_t place) { return one[place] != other[place]; });
  return at == size ? 0 : one[at] - other[at];
}
int bcmp(const void* a, const void* b, std::size_t size) noexcept {
  return memcmp(a, b, size);
}
int strncmp(const char* a, const char* b, std::size_t size) noexcept {
  const std::size_t at = placeOf(size, [&](std::size_t place) { return a[place] == '\0' || a[place] != b[place]; });
  return at == size ? 0 : static_cast<Byte>(a[at]) - static_cast<Byte>(b[at]);
}
int strcmp(const char* a, const char* b) noexcept {
  return strncmp(a, b, static_cast<std::size_t>(-1));
}
char* strchr(const char* text, int wanted) noexcept {
  const auto is_end = [&](std::size_t place) {
    return text[place] == '\0' || text[place] == static_cast<char>(wanted);
  };
  const std::size_t at = placeOf(static_cast<std::size_t>(-1), is_end);
  return text[at] == static_cast<char>(wanted) ? const_cast<char*>(text + at) : nullptr;
}
void* memchr(const void* text, int wanted, std::size_t size) noexcept {
  const auto* const from = static_cast<const Byte*>(text);
  const std::size_t at = placeOf(size, [&](std::size_t place) { return from[place] == static_cast<Byte>(wanted); });
  return at < size ? const_cast<Byte*>(from + at) : nullptr;
}

}  // extern "C"

namespace underact::test {

long steps() {
  return done;
}

}  // namespace underact::test
