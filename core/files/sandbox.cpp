#include "core/files/sandbox.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <vector>

namespace morphe::files {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MORPHE_SANITIZED
#elif defined(__has_feature)  // clang; other headers define it for g++, too
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MORPHE_SANITIZED
#endif
#endif

#if defined(__x86_64__)
#define MORPHE_AUDIT_ARCH AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define MORPHE_AUDIT_ARCH AUDIT_ARCH_AARCH64
#endif

void set_resource_limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard) {
  const rlimit limits{soft, hard};
  ::setrlimit(what, &limits);
}

#ifdef MORPHE_AUDIT_ARCH
constexpr long kAllowedSyscalls[] = {
    SYS_read,           SYS_pread64,      SYS_readv,           SYS_lseek,       SYS_fstat,
    SYS_newfstatat,     SYS_statx,        SYS_faccessat,       SYS_close,       SYS_flock,
    SYS_fcntl,          SYS_mmap,         SYS_munmap,          SYS_mremap,      SYS_mprotect,
    SYS_madvise,        SYS_brk,          SYS_futex,           SYS_getrandom,   SYS_getpid,
    SYS_gettid,         SYS_getuid,       SYS_geteuid,         SYS_uname,       SYS_clock_gettime,
    SYS_gettimeofday,   SYS_getrusage,    SYS_times,           SYS_sched_yield, SYS_rt_sigaction,
    SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_restart_syscall, SYS_exit,        SYS_exit_group,
#ifdef SYS_stat
    SYS_stat,           SYS_lstat,        SYS_access,
#endif
#ifdef MORPHE_SANITIZED
    SYS_sigaltstack,  // called by sanitizers before functions that do not return
#endif
};

sock_filter load(std::size_t offset) {
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
}
sock_filter return_verdict(unsigned verdict) { return BPF_STMT(BPF_RET | BPF_K, verdict); }
/// Skips the next instruction unless the loaded word is `value`.
sock_filter skip_unless_equal(unsigned value) {
  return BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
}

/// Returns a filter that allows only system calls for reading, and openat() of a file for reading.
std::vector<sock_filter> read_only_filter() {
  constexpr unsigned kDenyVerdict = SECCOMP_RET_ERRNO | EPERM;
  // Little-endian: the lower half of the third argument.
  constexpr std::size_t kOpenFlagsOffset = offsetof(seccomp_data, args) + 2 * sizeof(std::uint64_t);
  std::vector<sock_filter> filter{
      load(offsetof(seccomp_data, arch)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, MORPHE_AUDIT_ARCH, 1, 0),
      return_verdict(kDenyVerdict),
      load(offsetof(seccomp_data, nr)),
  };
  for (const long call : kAllowedSyscalls) {
    filter.push_back(skip_unless_equal(static_cast<unsigned>(call)));
    filter.push_back(return_verdict(SECCOMP_RET_ALLOW));
  }
  filter.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(SYS_openat), 1, 0));
  filter.push_back(return_verdict(kDenyVerdict));
  filter.push_back(load(kOpenFlagsOffset));
  filter.push_back(BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, O_ACCMODE | O_CREAT | O_TRUNC, 0, 1));
  filter.push_back(return_verdict(kDenyVerdict));
  filter.push_back(return_verdict(SECCOMP_RET_ALLOW));
  return filter;
}
#endif

}  // namespace

void enter_read_sandbox(std::uint64_t seconds, std::uint64_t bytes) {
  std::signal(SIGXCPU, SIG_DFL);
  set_resource_limit(RLIMIT_CPU, seconds, seconds + 1);
  set_resource_limit(RLIMIT_CORE, 0, 0);
#ifndef MORPHE_SANITIZED
  set_resource_limit(RLIMIT_DATA, bytes, bytes);  // would not suffice for a sanitizer's own memory
#else
  static_cast<void>(bytes);
#endif
#ifdef MORPHE_AUDIT_ARCH
  std::vector<sock_filter> filter = read_only_filter();
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
    ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
#endif
}

}  // namespace morphe::files
