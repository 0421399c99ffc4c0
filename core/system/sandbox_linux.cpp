#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "core/system/sandbox.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define UNDERACT_SANITIZED 1  // their shadow memory takes terabytes of addresses, and they need more system calls
#endif

namespace underact::system {
namespace {

bool limit(int resource, rlim_t max) {
  // A lower existing limit is fine, and cannot be raised.
  rlimit both{};
  if (::getrlimit(static_cast<decltype(RLIMIT_CORE)>(resource), &both) != 0) return false;
  both.rlim_max = std::min(both.rlim_max, max);
  both.rlim_cur = both.rlim_max;
  return ::setrlimit(static_cast<decltype(RLIMIT_CORE)>(resource), &both) == 0;
}

bool setLimits(std::uint64_t max_bytes, double max_cpu_s) {
  bool is_ok = limit(RLIMIT_CORE, 0);
  // In whole seconds, and one more to be sure. The starting program checks more closely.
  is_ok = limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(max_cpu_s)) + 1) && is_ok;
#ifdef UNDERACT_SANITIZED
  static_cast<void>(max_bytes);
#else
  is_ok = limit(RLIMIT_NOFILE, 0) && is_ok;
  is_ok = limit(RLIMIT_AS, max_bytes) && is_ok;
#endif
  return is_ok;
}

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;
#endif

// The calls for reading, writing, memory and the end, with the C library of Debian 12 and its relatives.
constexpr std::initializer_list<long> kAllowed{
    SYS_read,
    SYS_pread64,
    SYS_write,
    SYS_writev,
    SYS_lseek,
    SYS_fstat,
    SYS_brk,
    SYS_mmap,
    SYS_munmap,
    SYS_mremap,
    SYS_mprotect,
    SYS_madvise,
    SYS_futex,
    SYS_getrandom,
    SYS_clock_gettime,
    SYS_clock_nanosleep,  // the HDF5 library waits for a writer that is changing what it reads
    SYS_exit,
    SYS_exit_group,
    SYS_rt_sigreturn,
    SYS_rt_sigprocmask,
    SYS_sigaltstack,
#ifdef UNDERACT_SANITIZED
    // To check (through a pipe) whether memory exists, and to report findings.
    SYS_pipe2,
    SYS_close,
    SYS_getpid,
    SYS_gettid,
    SYS_tgkill,
    SYS_rt_sigaction,
    SYS_sched_yield,
    SYS_prctl,
    SYS_getrlimit,
    SYS_prlimit64,
#endif
};
// OpenMesh opens the materials named in an OBJ file, HDF5 what a link or a filter names; both continue without them.
constexpr std::initializer_list<long> kRefused{SYS_openat, SYS_newfstatat, SYS_close, SYS_ioctl, SYS_getcwd};

bool setFilter() {
  if (kMachine == 0) return false;
  const auto back = [](std::uint32_t what) { return sock_filter BPF_STMT(BPF_RET | BPF_K, what); };
  const auto load = [](std::size_t offset) {
    return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
  };
  const auto unless = [](std::uint32_t value, std::uint8_t skip) {
    return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skip);
  };
  std::vector<sock_filter> filter{load(offsetof(seccomp_data, arch)),
                                  sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 1, 0),
                                  back(SECCOMP_RET_KILL_PROCESS), load(offsetof(seccomp_data, nr))};
  const auto add = [&](std::initializer_list<long> calls, std::uint32_t what) {
    for (const long call : calls) {
      filter.push_back(unless(static_cast<std::uint32_t>(call), 1));
      filter.push_back(back(what));
    }
  };
  add(kAllowed, SECCOMP_RET_ALLOW);
  add(kRefused, SECCOMP_RET_ERRNO | EACCES);
  filter.push_back(back(SECCOMP_RET_KILL_PROCESS));
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace

bool enterSandbox(std::uint64_t max_bytes, double max_cpu_s) {
  bool is_ok = setLimits(max_bytes, max_cpu_s);
  is_ok = ::prctl(PR_SET_DUMPABLE, 0) == 0 && is_ok;
  return setFilter() && is_ok;
}

void endWithParent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

}  // namespace underact::system

#undef UNDERACT_SANITIZED
#endif
