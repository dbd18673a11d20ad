/* A file is cut only at its end, and only by what was just written. */
#include "files/write-lines.h"

#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

static void take_back_part(int file, const char *text, gsize written)
{
    const int reason = errno;
    gsize whole = written;
    while (whole > 0 && text[whole - 1] != '\n')
        whole--;
    struct stat status;
    const off_t end = lseek(file, 0, SEEK_CUR), part = (off_t)(written - whole);
    if (part > 0 && end >= part && fstat(file, &status) == 0 && status.st_size == end &&
        ftruncate(file, end - part) == 0)
        (void)lseek(file, end - part, SEEK_SET);
    errno = reason;
}

gboolean tinker_write_lines(int file, const char *text, gsize size)
{
    gsize done = 0;
    while (done < size) {
        const gssize written = write(file, text + done, size - done);
        if (written < 0 && errno == EINTR) continue;
        if (written == 0) errno = EIO;
        if (written <= 0) {
            take_back_part(file, text, done);
            return FALSE;
        }
        done += (gsize)written;
    }
    return TRUE;
}
