#include "tests/malloc/counter.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>
#include <cstddef>

namespace {

struct Counts {
  bool armed = false;
  long allocations = 0;
  long frees = 0;
  long locks = 0;
};
constinit thread_local Counts counts;  // constant: a first touch in malloc must not itself allocate

void count(long Counts::*which) {
  if (counts.armed) ++(counts.*which);
}

}  // namespace

extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t many, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* old);

void* malloc(std::size_t size) noexcept {
  count(&Counts::allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t many, std::size_t size) noexcept {
  count(&Counts::allocations);
  return __libc_calloc(many, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  count(&Counts::allocations);
  return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  count(&Counts::allocations);
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  count(&Counts::allocations);
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
  count(&Counts::allocations);
  *place = __libc_memalign(alignment, size);
  return *place == nullptr ? ENOMEM : 0;
}
void free(void* old) noexcept {
  count(&Counts::frees);
  __libc_free(old);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const Lock real = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  count(&Counts::locks);
  return real(mutex);
}

}  // extern "C"

namespace underact::test {

Watch::Watch() {
  counts = {};
  counts.armed = true;
}
Watch::~Watch() {
  counts.armed = false;
}
long Watch::allocations() const {
  return counts.allocations;
}
long Watch::frees() const {
  return counts.frees;
}
long Watch::locks() const {
  return counts.locks;
}

}  // namespace underact::test
