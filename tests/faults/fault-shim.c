/* Calls of the C library on files that fail when they are told to. The environment says which:
 *     TEST_FAULT          "CALL NUMBER KIND": the NUMBERth call (from 1) of open, read, write, fsync, close or rename
 * fails; KIND is the name of an error, which all later calls of it have too, "once" for a single EINTR, or "short" for
 * a single read or write of half of what was asked for TEST_FAULT_FOLDER   calls on files in this folder are meant;
 * others are left alone TEST_FAULT_REACHED  a file that is made when the call comes Streams do their reading and
 * writing inside the C library, where nobody can put anything in front: those on such files are replaced by streams
 * over functions of this file. */
// Else open and fopen are other names for open64 and fopen64, which both are needed here.
#undef _FILE_OFFSET_BITS
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#define VISIBLE __attribute__((visibility("default")))

typedef enum { PASS, FAIL, INTERRUPT, SHORTEN } Verdict;

static struct {
    int ready, number, calls, code;
    char call[16];
    const char *folder, *reached;
    Verdict verdict;
} plan;

static const struct {
    const char *name;
    int code;
} errors[] = {{"ENOSPC", ENOSPC}, {"EIO", EIO}, {"EACCES", EACCES}, {"EDQUOT", EDQUOT}};

static void read_plan(void)
{
    if (plan.ready) return;
    plan.ready = 1;
    char kind[16] = "";
    const char *text = getenv("TEST_FAULT");
    plan.folder = getenv("TEST_FAULT_FOLDER");
    plan.reached = getenv("TEST_FAULT_REACHED");
    if (text == NULL || plan.folder == NULL || plan.reached == NULL) return;
    if (sscanf(text, "%15s %d %15s", plan.call, &plan.number, kind) != 3) abort();
    plan.verdict = strcmp(kind, "once") == 0 ? INTERRUPT : strcmp(kind, "short") == 0 ? SHORTEN : FAIL;
    for (size_t i = 0; i < sizeof errors / sizeof errors[0]; i++)
        if (strcmp(errors[i].name, kind) == 0) plan.code = errors[i].code;
    if (plan.verdict == FAIL && plan.code == 0) abort();
}

static int is_meant(const char *path)
{
    read_plan();
    return plan.folder != NULL && strncmp(path, plan.folder, strlen(plan.folder)) == 0;
}

static int is_meant_file(int file)
{
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    const ssize_t length = readlink(link, path, sizeof path - 1);
    if (length < 0) return 0;
    path[length] = '\0';
    return is_meant(path);
}

/* What becomes of this call, which is on a file in the folder. */
static Verdict judge(const char *call)
{
    if (plan.number == 0 || strcmp(call, plan.call) != 0) return PASS;
    plan.calls++;
    if (plan.calls < plan.number || (plan.calls > plan.number && plan.verdict != FAIL)) return PASS;
    const int file = (int)syscall(SYS_openat, AT_FDCWD, plan.reached, O_CREAT | O_WRONLY | O_CLOEXEC, 0600);
    if (file >= 0) syscall(SYS_close, file);
    if (plan.verdict == FAIL) errno = plan.code;
    if (plan.verdict == INTERRUPT) errno = EINTR;
    return plan.verdict;
}

/* The real function behind a wrapper. */
#define REAL(name, type)                                                                                               \
    static type real_##name;                                                                                           \
    if (real_##name == NULL) {                                                                                         \
        void *symbol_ = dlsym(RTLD_NEXT, #name);                                                                       \
        memcpy(&real_##name, &symbol_, sizeof symbol_);                                                                \
    }

typedef ssize_t (*ReadCall)(int, void *, size_t);
typedef ssize_t (*WriteCall)(int, const void *, size_t);
typedef ssize_t (*ReadPlaceCall)(int, void *, size_t, off64_t);
typedef ssize_t (*WritePlaceCall)(int, const void *, size_t, off64_t);
typedef int (*FileCall)(int);
typedef int (*RenameCall)(const char *, const char *);
typedef int (*OpenCall)(const char *, int, ...);
typedef FILE *(*StreamCall)(const char *, const char *);
typedef FILE *(*AdoptCall)(int, const char *);

VISIBLE ssize_t read(int file, void *bytes, size_t count)
{
    REAL(read, ReadCall)
    const Verdict verdict = is_meant_file(file) ? judge("read") : PASS;
    if (verdict == FAIL || verdict == INTERRUPT) return -1;
    return real_read(file, bytes, verdict == SHORTEN && count > 1 ? count / 2 : count);
}

VISIBLE ssize_t write(int file, const void *bytes, size_t count)
{
    REAL(write, WriteCall)
    const Verdict verdict = is_meant_file(file) ? judge("write") : PASS;
    if (verdict == FAIL || verdict == INTERRUPT) return -1;
    return real_write(file, bytes, verdict == SHORTEN && count > 1 ? count / 2 : count);
}

/* At a place of the file; the second name is that of programs with large files. */
#define READ_AT_PLACE(name)                                                                                            \
    VISIBLE ssize_t name(int file, void *bytes, size_t count, off64_t place)                                           \
    {                                                                                                                  \
        REAL(name, ReadPlaceCall)                                                                                      \
        const Verdict verdict = is_meant_file(file) ? judge("read") : PASS;                                            \
        if (verdict == FAIL || verdict == INTERRUPT) return -1;                                                        \
        return real_##name(file, bytes, verdict == SHORTEN && count > 1 ? count / 2 : count, place);                   \
    }
READ_AT_PLACE(pread)
READ_AT_PLACE(pread64)

#define WRITE_AT_PLACE(name)                                                                                           \
    VISIBLE ssize_t name(int file, const void *bytes, size_t count, off64_t place)                                     \
    {                                                                                                                  \
        REAL(name, WritePlaceCall)                                                                                     \
        const Verdict verdict = is_meant_file(file) ? judge("write") : PASS;                                           \
        if (verdict == FAIL || verdict == INTERRUPT) return -1;                                                        \
        return real_##name(file, bytes, verdict == SHORTEN && count > 1 ? count / 2 : count, place);                   \
    }
WRITE_AT_PLACE(pwrite)
WRITE_AT_PLACE(pwrite64)

VISIBLE int fsync(int file)
{
    REAL(fsync, FileCall)
    const Verdict verdict = is_meant_file(file) ? judge("fsync") : PASS;
    return verdict == FAIL || verdict == INTERRUPT ? -1 : real_fsync(file);
}

/* The file is closed all the same, as Linux does it; also after EINTR. */
VISIBLE int close(int file)
{
    REAL(close, FileCall)
    const Verdict verdict = is_meant_file(file) ? judge("close") : PASS;
    const int code = errno;
    const int result = real_close(file);
    if (verdict != FAIL && verdict != INTERRUPT) return result;
    errno = code;
    return -1;
}

VISIBLE int rename(const char *from, const char *to)
{
    REAL(rename, RenameCall)
    const Verdict verdict = is_meant(to) ? judge("rename") : PASS;
    return verdict == FAIL ? -1 : real_rename(from, to);
}

static int mode_of(int flags, va_list arguments)
{
    return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, int) : 0;
}

#define OPEN(name)                                                                                                     \
    VISIBLE int name(const char *path, int flags, ...)                                                                 \
    {                                                                                                                  \
        REAL(name, OpenCall)                                                                                           \
        va_list arguments;                                                                                             \
        va_start(arguments, flags);                                                                                    \
        const int mode = mode_of(flags, arguments);                                                                    \
        va_end(arguments);                                                                                             \
        const Verdict verdict = is_meant(path) ? judge("open") : PASS;                                                 \
        return verdict == FAIL || verdict == INTERRUPT ? -1 : real_##name(path, flags, mode);                          \
    }
OPEN(open)
OPEN(open64)

/* Streams ---------------------------------------------------------------------------------------------------------- */

static ssize_t stream_read(void *file, char *bytes, size_t count)
{
    return read((int)(long)file, bytes, count);
}

/* Goes on after a short write, as the C library's own streams do. */
static ssize_t stream_write(void *file, const char *bytes, size_t count)
{
    size_t done = 0;
    while (done < count) {
        const ssize_t written = write((int)(long)file, bytes + done, count - done);
        if (written < 0) break; // fewer than asked for is a failure, see fopencookie(3)
        done += (size_t)written;
    }
    return (ssize_t)done;
}

static int stream_seek(void *file, off64_t *offset, int from)
{
    const off_t now = lseek((int)(long)file, *offset, from);
    if (now >= 0) *offset = now;
    return now < 0 ? -1 : 0;
}

static int stream_close(void *file)
{
    return close((int)(long)file);
}

static const cookie_io_functions_t stream_functions = {stream_read, stream_write, stream_seek, stream_close};

static FILE *stream_over(int file, const char *mode)
{
    return fopencookie((void *)(long)file, mode, stream_functions);
}

static int flags_of(const char *mode)
{
    const int both = strchr(mode, '+') != NULL;
    if (mode[0] == 'r') return both ? O_RDWR : O_RDONLY;
    return (both ? O_RDWR : O_WRONLY) | O_CREAT | (mode[0] == 'a' ? O_APPEND : O_TRUNC);
}

#define FOPEN(name)                                                                                                    \
    VISIBLE FILE *name(const char *path, const char *mode)                                                             \
    {                                                                                                                  \
        REAL(name, StreamCall)                                                                                         \
        if (!is_meant(path)) return real_##name(path, mode);                                                           \
        const int file = open(path, flags_of(mode) | O_CLOEXEC, 0666);                                                 \
        return file < 0 ? NULL : stream_over(file, mode);                                                              \
    }
FOPEN(fopen)
FOPEN(fopen64)

VISIBLE FILE *fdopen(int file, const char *mode)
{
    REAL(fdopen, AdoptCall)
    return is_meant_file(file) ? stream_over(file, mode) : real_fdopen(file, mode);
}
