// A library to preload (LD_PRELOAD) that counts a program's calls for files and its allocations,
// and fails one of them. Only the process that was started counts, not what it forks.
//   MORPHE_FAULT_COUNT=FILE  writes "io NUMBER NAME" for each call for a file and, for the first
//                            allocation of every distinct call stack, "memory NUMBER"; last, "end
//                            IO ALLOCATIONS"
//   MORPHE_FAULT_IO=N        fails the Nth call for a file with the error of its kind
//   MORPHE_FAULT_MEMORY=N    fails the Nth allocation, unless HDF5 makes it while it initialises
//                            its errors: then it reports that error as another one without end
//   MORPHE_FAULT_REPORT=FILE creates FILE when the call fails, with the name of the library or
//                            program that made it
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <dirent.h>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

constexpr int kDepth = 12;       // frames that tell call stacks apart
constexpr int kAllFrames = 128;  // frames that are searched for a function
constexpr std::size_t kStackSlots = std::size_t{1} << 20;

std::atomic<long> io_calls{0}, allocations{0};
long failed_io = 0, failed_allocation = 0;
int count_descriptor = -1;
pid_t own_process = 0;
const char* report_file = nullptr;
std::atomic<bool> ready{false};
std::atomic<std::uint64_t>* seen_stacks = nullptr;
thread_local bool inside = false;

struct Inside {
  bool was = inside;
  Inside() { inside = true; }
  ~Inside() { inside = was; }
};

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

void write_line(const char* format, ...) {
  char line[128];
  va_list values;
  va_start(values, format);
  const int length = std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  static const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
  if (length > 0 && real(count_descriptor, line, length) != length) std::abort();
}

/// Returns the name of the library or program that called: of the first frame of the call stack
/// outside this library and the C library.
const char* caller() {
  void* stack[kAllFrames];
  const int depth = backtrace(stack, kAllFrames);
  Dl_info own, place;
  dladdr(reinterpret_cast<void*>(&caller), &own);
  for (int k = 0; k < depth; ++k) {
    if (!dladdr(stack[k], &place) || place.dli_fbase == own.dli_fbase) continue;
    const char* const slash = std::strrchr(place.dli_fname, '/');
    const char* const name = slash ? slash + 1 : place.dli_fname;
    if (std::strncmp(name, "libc.so", 7) != 0) return name;
  }
  return "";
}

void report() {
  static const auto real_open = next<int (*)(const char*, int, ...)>("open");
  static const auto real_write = next<ssize_t (*)(int, const void*, size_t)>("write");
  if (!report_file) return;
  const int file = real_open(report_file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const char* const name = caller();
  const auto length = static_cast<ssize_t>(std::strlen(name));
  if (file < 0 || real_write(file, name, std::strlen(name)) != length) std::abort();
}

[[gnu::constructor]] void begin() {
  const Inside now;
  const auto number = [](const char* name) {
    const char* const text = std::getenv(name);
    return text ? std::atol(text) : 0;
  };
  own_process = getpid();
  failed_io = number("MORPHE_FAULT_IO");
  failed_allocation = number("MORPHE_FAULT_MEMORY");
  report_file = std::getenv("MORPHE_FAULT_REPORT");
  if (const char* const file = std::getenv("MORPHE_FAULT_COUNT")) {
    static const auto real = next<int (*)(const char*, int, ...)>("open");
    count_descriptor = real(file, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
    void* stack[kDepth];
    backtrace(stack, kDepth);  // loads what it needs before it is counted
    seen_stacks = static_cast<std::atomic<std::uint64_t>*>(
        mmap(nullptr, kStackSlots * sizeof *seen_stacks, PROT_READ | PROT_WRITE,
             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  }
  ready = true;
}

[[gnu::destructor]] void end() {
  if (count_descriptor >= 0 && getpid() == own_process) {
    const Inside now;
    write_line("end %ld %ld\n", io_calls.load(), allocations.load());
  }
  ready = false;
}

bool is_new_stack() {
  void* stack[kDepth];
  const int depth = backtrace(stack, kDepth);
  std::uint64_t hash = 1469598103934665603u;
  for (int k = 2; k < depth; ++k)
    hash = (hash ^ reinterpret_cast<std::uint64_t>(stack[k])) * 1099511628211u;
  hash |= 1;
  for (std::size_t slot = hash % kStackSlots;; slot = (slot + 1) % kStackSlots) {
    std::uint64_t empty = 0;
    if (seen_stacks[slot].compare_exchange_strong(empty, hash)) return true;
    if (empty == hash) return false;
  }
}

bool counts() { return ready && !inside && getpid() == own_process; }

/// Counts a call for a file; returns true if it is to fail.
bool fails(const char* name) {
  if (!counts()) return false;
  const Inside now;
  const long number = ++io_calls;
  if (count_descriptor >= 0) write_line("io %ld %s\n", number, name);
  if (number != failed_io) return false;
  report();
  return true;
}

/// Returns true if an exported function of this name is on the call stack.
bool is_called_by(const char* function) {
  void* stack[kAllFrames];
  const int depth = backtrace(stack, kAllFrames);
  for (int k = 0; k < depth; ++k) {
    Dl_info place;
    if (dladdr(stack[k], &place) && place.dli_sname && !std::strcmp(place.dli_sname, function))
      return true;
  }
  return false;
}

bool allocation_fails() {
  if (!counts()) return false;
  const Inside now;
  const long number = ++allocations;
  if (count_descriptor >= 0 && is_new_stack()) write_line("memory %ld\n", number);
  if (number != failed_allocation || is_called_by("H5E_init")) return false;
  report();
  errno = ENOMEM;
  return true;
}

template <class Result>
Result failure(int error, Result result) {
  errno = error;
  return result;
}

}  // namespace

/// Defines a function that fails with an error and a result, or does what it does.
#define MORPHE_FAIL(Result, name, parameters, arguments, error, result)    \
  extern "C" Result name parameters {                                      \
    static const auto real = next<Result(*) parameters>(#name);            \
    return fails(#name) ? failure<Result>(error, result) : real arguments; \
  }

/// The same of a function that may create a file and then takes its mode.
#define MORPHE_FAIL_OPEN(name, parameters, arguments)                \
  extern "C" int name parameters {                                   \
    static const auto real = next<int(*) parameters>(#name);         \
    mode_t mode = 0;                                                 \
    if (flags & (O_CREAT | O_TMPFILE)) {                             \
      va_list values;                                                \
      va_start(values, flags);                                       \
      mode = va_arg(values, mode_t);                                 \
      va_end(values);                                                \
    }                                                                \
    return fails(#name) ? failure<int>(EMFILE, -1) : real arguments; \
  }

MORPHE_FAIL_OPEN(open, (const char* path, int flags, ...), (path, flags, mode))
MORPHE_FAIL_OPEN(open64, (const char* path, int flags, ...), (path, flags, mode))
MORPHE_FAIL_OPEN(openat, (int folder, const char* path, int flags, ...),
                 (folder, path, flags, mode))
MORPHE_FAIL_OPEN(openat64, (int folder, const char* path, int flags, ...),
                 (folder, path, flags, mode))
MORPHE_FAIL(FILE*, fopen, (const char* path, const char* mode), (path, mode), EMFILE, nullptr)
MORPHE_FAIL(FILE*, fopen64, (const char* path, const char* mode), (path, mode), EMFILE, nullptr)
MORPHE_FAIL(DIR*, opendir, (const char* path), (path), EMFILE, nullptr)
MORPHE_FAIL(DIR*, fdopendir, (int folder), (folder), ENOMEM, nullptr)
MORPHE_FAIL(ssize_t, read, (int file, void* to, size_t count), (file, to, count), EIO, -1)
MORPHE_FAIL(ssize_t, pread, (int file, void* to, size_t count, off_t at), (file, to, count, at),
            EIO, -1)
MORPHE_FAIL(ssize_t, pread64, (int file, void* to, size_t count, off64_t at), (file, to, count, at),
            EIO, -1)
MORPHE_FAIL(ssize_t, write, (int file, const void* from, size_t count), (file, from, count), ENOSPC,
            -1)
MORPHE_FAIL(ssize_t, pwrite, (int file, const void* from, size_t count, off_t at),
            (file, from, count, at), ENOSPC, -1)
MORPHE_FAIL(ssize_t, pwrite64, (int file, const void* from, size_t count, off64_t at),
            (file, from, count, at), ENOSPC, -1)
MORPHE_FAIL(ssize_t, writev, (int file, const struct iovec* from, int count), (file, from, count),
            ENOSPC, -1)
MORPHE_FAIL(ssize_t, sendfile, (int to, int from, off_t* at, size_t count), (to, from, at, count),
            EIO, -1)
MORPHE_FAIL(ssize_t, copy_file_range,
            (int from, off64_t* from_at, int to, off64_t* to_at, size_t count, unsigned flags),
            (from, from_at, to, to_at, count, flags), EIO, -1)
MORPHE_FAIL(int, fsync, (int file), (file), EIO, -1)
MORPHE_FAIL(int, fdatasync, (int file), (file), EIO, -1)
MORPHE_FAIL(int, ftruncate, (int file, off_t length), (file, length), ENOSPC, -1)
MORPHE_FAIL(int, ftruncate64, (int file, off64_t length), (file, length), ENOSPC, -1)
MORPHE_FAIL(int, rename, (const char* from, const char* to), (from, to), EIO, -1)
MORPHE_FAIL(int, unlink, (const char* path), (path), EIO, -1)
MORPHE_FAIL(int, unlinkat, (int folder, const char* path, int flags), (folder, path, flags), EIO,
            -1)
MORPHE_FAIL(int, remove, (const char* path), (path), EIO, -1)
MORPHE_FAIL(int, mkdir, (const char* path, mode_t mode), (path, mode), ENOSPC, -1)
MORPHE_FAIL(int, stat, (const char* path, struct stat* to), (path, to), EIO, -1)
MORPHE_FAIL(int, lstat, (const char* path, struct stat* to), (path, to), EIO, -1)
MORPHE_FAIL(int, fstat, (int file, struct stat* to), (file, to), EIO, -1)
MORPHE_FAIL(int, stat64, (const char* path, struct stat64* to), (path, to), EIO, -1)
MORPHE_FAIL(int, lstat64, (const char* path, struct stat64* to), (path, to), EIO, -1)
MORPHE_FAIL(int, fstat64, (int file, struct stat64* to), (file, to), EIO, -1)
MORPHE_FAIL(int, access, (const char* path, int mode), (path, mode), EIO, -1)
MORPHE_FAIL(void*, mmap, (void* at, size_t length, int protection, int flags, int file, off_t from),
            (at, length, protection, flags, file, from), ENOMEM, MAP_FAILED)

/// A call that fails still closes.
extern "C" int close(int file) {
  static const auto real = next<int (*)(int)>("close");
  const int result = real(file);
  return fails("close") ? failure<int>(EIO, -1) : result;
}
extern "C" int fclose(FILE* file) {
  static const auto real = next<int (*)(FILE*)>("fclose");
  const int result = real(file);
  return fails("fclose") ? failure<int>(EIO, EOF) : result;
}

extern "C" void* malloc(size_t bytes) {
  return allocation_fails() ? nullptr : __libc_malloc(bytes);
}
extern "C" void* calloc(size_t count, size_t bytes) {
  return allocation_fails() ? nullptr : __libc_calloc(count, bytes);
}
extern "C" void* realloc(void* old, size_t bytes) {
  return allocation_fails() ? nullptr : __libc_realloc(old, bytes);
}
extern "C" void* aligned_alloc(size_t alignment, size_t bytes) {
  return allocation_fails() ? nullptr : __libc_memalign(alignment, bytes);
}
extern "C" int posix_memalign(void** to, size_t alignment, size_t bytes) {
  if (allocation_fails()) return ENOMEM;
  *to = __libc_memalign(alignment, bytes);
  return *to ? 0 : ENOMEM;
}
