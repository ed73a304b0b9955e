// Library preloaded into a program: makes one of the program's system calls or allocations fail, as with a bad disk or
// full memory, and logs its calls on files.
//
// FAULT_KIND     kind of call: write, short-write, rename, fsync, close, open, mkdir (failing with EIO, ENOSPC or
//                EACCES as usual) or memory
// FAULT_AT       number of the call that fails, counted from 1 at the start of main; no call fails if 0 or unset
// FAULT_FROM_ON  1: all calls from FAULT_AT on fail, as on a disk that stays full
// FAULT_THREADS  1: only calls of threads other than the main thread count
// FAULT_TALLY    file to which the number of calls is appended when the program ends
// FAULT_NOTES    file to which calls are logged: "open FD PATH", "write FD", "fsync FD", "close FD", "rename FROM TO"
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
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

std::atomic<bool> is_begun{false};
std::atomic<long> calls{0};
long fails_at = 0;
bool fails_from_on = false, fails_in_threads = false;
const char *kind = "", *notes = nullptr, *tally = nullptr;
constexpr int kMostFiles = 1024;
std::atomic<bool> is_written[kMostFiles];  // descriptors that were opened for writing

/// Counts a call of kind `of` and returns true if the call must fail.
bool fails(const char* of) {
  if (!is_begun || std::strcmp(kind, of) != 0) return false;
  if (fails_in_threads && syscall(SYS_gettid) == syscall(SYS_getpid)) return false;
  const long call = ++calls;
  return fails_at > 0 && (call == fails_at || (fails_from_on && call > fails_at));
}

bool isOfFile(int file) { return file > 2 && file < kMostFiles && is_written[file]; }

void append(const char* path, const char* text, size_t size) {
  const auto file =
      static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644));
  if (file < 0) return;
  (void)syscall(SYS_write, file, text, size);
  syscall(SYS_close, file);
}

__attribute__((format(printf, 1, 2))) void note(const char* format, ...) {
  if (!is_begun || !notes) return;
  char line[2 * 4096 + 64];
  va_list words;
  va_start(words, format);
  const int size = std::vsnprintf(line, sizeof line, format, words);
  va_end(words);
  append(notes, line, static_cast<size_t>(size));
}

void writeTally() {
  char text[32];
  if (tally) append(tally, text, static_cast<size_t>(std::snprintf(text, sizeof text, "%ld\n", calls.load())));
}

/// Sets errno and returns -1, as a failing system call does.
long failure(int error) {
  errno = error;
  return -1;
}

int opened(int folder, const char* path, int flags, mode_t mode) {
  const bool writes = (flags & O_ACCMODE) != O_RDONLY;
  struct stat found {};
  const bool is_special = ::fstatat(folder, path, &found, 0) == 0 && !S_ISREG(found.st_mode);
  if (writes && !is_special && fails("open")) return static_cast<int>(failure(EACCES));
  const auto file = static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
  if (file < 0 || file >= kMostFiles) return file;
  is_written[file] = writes && !is_special;
  note("open %d %s\n", file, path);
  return file;
}

long written(int file, size_t size, const void* from, bool& is_done) {
  if (!isOfFile(file)) return is_done = false;
  note("write %d\n", file);
  is_done = true;
  if (fails("write")) return failure(ENOSPC);
  if (size > 1 && fails("short-write")) return syscall(SYS_write, file, from, size / 2);
  return is_done = false;
}

int (*real_main)(int, char**, char**) = nullptr;

int mainWithFaults(int argc, char** argv, char** environment) {
  is_begun = true;
  return real_main(argc, argv, environment);
}

__attribute__((constructor)) void readEnvironment() {
  const auto word = [](const char* name) { return std::getenv(name); };
  if (const char* text = word("FAULT_KIND")) kind = text;
  if (const char* text = word("FAULT_AT")) fails_at = std::atol(text);
  fails_from_on = word("FAULT_FROM_ON") != nullptr;
  fails_in_threads = word("FAULT_THREADS") != nullptr;
  notes = word("FAULT_NOTES");
  tally = word("FAULT_TALLY");
  ::unsetenv("LD_PRELOAD");  // child processes run without faults
  std::atexit(writeTally);
}

mode_t modeOf(int flags, va_list words) { return flags & (O_CREAT | __O_TMPFILE) ? va_arg(words, mode_t) : 0; }

template <class Function>
Function realOf(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int __libc_start_main(int (*program)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*ld_fini)(), void* stack) {
  using Start = int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
  real_main = program;
  return realOf<Start>("__libc_start_main")(mainWithFaults, argc, argv, init, fini, ld_fini, stack);
}

int open(const char* path, int flags, ...) {
  va_list words;
  va_start(words, flags);
  const mode_t mode = modeOf(flags, words);
  va_end(words);
  return opened(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list words;
  va_start(words, flags);
  const mode_t mode = modeOf(flags, words);
  va_end(words);
  return opened(AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list words;
  va_start(words, flags);
  const mode_t mode = modeOf(flags, words);
  va_end(words);
  return opened(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  if (mode[0] != 'r' && fails("open")) {
    errno = EACCES;
    return nullptr;
  }
  FILE* stream = realOf<FILE* (*)(const char*, const char*)>("fopen")(path, mode);
  if (!stream || mode[0] == 'r') return stream;
  struct stat found {};
  const int file = ::fileno(stream);
  if (file < kMostFiles) is_written[file] = ::fstat(file, &found) == 0 && S_ISREG(found.st_mode);
  note("open %d %s\n", file, path);
  return stream;
}

FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }

ssize_t write(int file, const void* from, size_t size) {
  bool is_done = false;
  const long result = written(file, size, from, is_done);
  return is_done ? result : syscall(SYS_write, file, from, size);
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  bool is_done = false;
  const long result = written(file, parts->iov_len, parts->iov_base, is_done);
  return is_done ? result : syscall(SYS_writev, file, parts, count);
}

int fsync(int file) {
  note("fsync %d\n", file);
  return static_cast<int>(fails("fsync") ? failure(EIO) : syscall(SYS_fsync, file));
}

int close(int file) {
  const bool is_file = isOfFile(file);
  if (is_file) is_written[file] = false;
  note("close %d\n", file);
  const auto result = static_cast<int>(syscall(SYS_close, file));
  return is_file && fails("close") ? static_cast<int>(failure(EIO)) : result;
}

int rename(const char* from, const char* to) {
  if (fails("rename")) return static_cast<int>(failure(EIO));
  note("rename %s %s\n", from, to);
  return static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}

int mkdir(const char* path, mode_t mode) {
  return static_cast<int>(fails("mkdir") ? failure(EACCES) : syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}

void* malloc(size_t size) {
  if (!fails("memory")) return __libc_malloc(size);
  errno = ENOMEM;
  return nullptr;
}

void* calloc(size_t count, size_t size) {
  if (!fails("memory")) return __libc_calloc(count, size);
  errno = ENOMEM;
  return nullptr;
}

void* realloc(void* old, size_t size) {
  if (!fails("memory")) return __libc_realloc(old, size);
  errno = ENOMEM;
  return nullptr;
}

void* aligned_alloc(size_t alignment, size_t size) {
  if (!fails("memory")) return __libc_memalign(alignment, size);
  errno = ENOMEM;
  return nullptr;
}

void* memalign(size_t alignment, size_t size) { return aligned_alloc(alignment, size); }

int posix_memalign(void** to, size_t alignment, size_t size) {
  void* const memory = aligned_alloc(alignment, size);
  if (!memory) return ENOMEM;
  *to = memory;
  return 0;
}
}
