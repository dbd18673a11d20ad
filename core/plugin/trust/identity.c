/* The identity of a file, and the little of the ELF format that is needed: the header, and the note with the build id
 * (System V ABI, "ELF header", "Program header", "Note section"; NT_GNU_BUILD_ID of the GNU tools). */
#include "plugin/trust/identity.h"

#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plugin/trust/refuse.h"

/* Notes are a few dozen bytes; more is not worth reading. */
#define MOST_NOTES   65536
#define MOST_HEADERS 256

#if __SIZEOF_POINTER__ == 8
#define NATIVE_CLASS ELFCLASS64
#else
#define NATIVE_CLASS ELFCLASS32
#endif

static int open_to_read(const char *path)
{
    // Non-blocking, so that a pipe of that name cannot keep us waiting.
    return open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

static gboolean read_exactly(int file, void *target, gsize size, guint64 offset)
{
    return offset <= G_MAXINT64 && pread(file, target, size, (off_t)offset) == (gssize)size;
}

static gboolean has_elf_magic(const unsigned char *ident)
{
    return memcmp(ident, ELFMAG, SELFMAG) == 0;
}

static gboolean read_header(int file, ElfW(Ehdr) * header)
{
    return read_exactly(file, header, sizeof *header, 0) && has_elf_magic(header->e_ident) &&
           header->e_ident[EI_CLASS] == NATIVE_CLASS && header->e_phentsize == sizeof(ElfW(Phdr));
}

static char *hexadecimal(const guint8 *bytes, gsize size)
{
    GString *text = g_string_new(NULL);
    for (gsize i = 0; i < size; i++)
        g_string_append_printf(text, "%02x", bytes[i]);
    return g_string_free(text, FALSE);
}

/* Looks for the build id among the notes of one segment. Every size is checked against what is left. */
static char *find_build_id(const guint8 *notes, gsize left)
{
    while (left >= sizeof(ElfW(Nhdr))) {
        ElfW(Nhdr) note;
        memcpy(&note, notes, sizeof note);
        const guint64 name_size = ((guint64)note.n_namesz + 3) & ~(guint64)3;
        const guint64 value_size = ((guint64)note.n_descsz + 3) & ~(guint64)3;
        const guint64 whole = sizeof note + name_size + value_size;
        if (whole > left) return NULL;
        const guint8 *name = notes + sizeof note;
        if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && memcmp(name, "GNU", 4) == 0)
            return hexadecimal(name + name_size, note.n_descsz);
        notes += whole;
        left -= whole;
    }
    return NULL;
}

static char *build_id_of_segment(int file, const ElfW(Phdr) * segment)
{
    if (segment->p_type != PT_NOTE || segment->p_filesz == 0 || segment->p_filesz > MOST_NOTES) return NULL;
    g_autofree guint8 *notes = g_malloc(segment->p_filesz);
    if (!read_exactly(file, notes, segment->p_filesz, segment->p_offset)) return NULL;
    return find_build_id(notes, segment->p_filesz);
}

static char *build_id_of_file(int file)
{
    ElfW(Ehdr) header;
    if (!read_header(file, &header)) return NULL;
    const guint count = MIN(header.e_phnum, MOST_HEADERS);
    for (guint i = 0; i < count; i++) {
        ElfW(Phdr) segment;
        if (!read_exactly(file, &segment, sizeof segment, header.e_phoff + (guint64)i * sizeof segment)) return NULL;
        char *build_id = build_id_of_segment(file, &segment);
        if (build_id != NULL) return build_id;
    }
    return NULL;
}

gboolean tinker_identity_read(const char *path, TinkerIdentity *identity, GError **error)
{
    struct stat status;
    if (stat(path, &status) != 0) return tinker_fail_file(error, "it cannot be read: %s", g_strerror(errno));
    if (!S_ISREG(status.st_mode)) return tinker_fail_file(error, "it is not a regular file");
    identity->size = status.st_size;
    identity->mtime_ns = (gint64)status.st_mtim.tv_sec * 1000000000 + status.st_mtim.tv_nsec;
    return TRUE;
}

gboolean tinker_identity_same_file_time(const TinkerIdentity *a, const TinkerIdentity *b)
{
    return a->size == b->size && a->mtime_ns == b->mtime_ns;
}

gboolean tinker_elf_check(const char *path, GError **error)
{
    const int file = open_to_read(path);
    if (file < 0) return tinker_fail_file(error, "it cannot be read: %s", g_strerror(errno));
    unsigned char ident[EI_NIDENT] = {0};
    const gssize got = pread(file, ident, sizeof ident, 0);
    const int reason = errno;
    close(file);
    if (got < 0) return tinker_fail_file(error, "it cannot be read: %s", g_strerror(reason));
    if (got == 0) return tinker_refuse(error, "it is empty, a shared object was expected");
    if (got < (gssize)sizeof ident || !has_elf_magic(ident))
        return tinker_refuse(error,
                             "it is no shared object: it begins with %02x %02x %02x %02x, 7f 45 4c 46 was expected",
                             ident[0], ident[1], ident[2], ident[3]);
    if (ident[EI_CLASS] != NATIVE_CLASS)
        return tinker_refuse(error, "it is a shared object of ELF class %d, this host needs class %d (%d bits)",
                             ident[EI_CLASS], NATIVE_CLASS, __SIZEOF_POINTER__ * 8);
    return TRUE;
}

char *tinker_elf_build_id(const char *path)
{
    const int file = open_to_read(path);
    if (file < 0) return NULL;
    char *build_id = build_id_of_file(file);
    close(file);
    return build_id;
}
