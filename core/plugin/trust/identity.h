/* Which file a manifest or a remembered refusal speaks of. */
#ifndef TINKER_PLUGIN_IDENTITY_H
#define TINKER_PLUGIN_IDENTITY_H

#include "plugin/trust/plugin-error.h"

/* A file as it is now: its size and the time of its last change. */
typedef struct {
    gint64 size;     /* bytes */
    gint64 mtime_ns; /* since 1970 */
} TinkerIdentity;

/* Reads the identity of a regular file; _FILE on failure. */
gboolean tinker_identity_read(const char *path, TinkerIdentity *identity, GError **error);

/* Whether size and time agree. */
gboolean tinker_identity_same_file_time(const TinkerIdentity *a, const TinkerIdentity *b);

/* Refuses what is not a shared object of this kind of machine, before the dynamic linker sees it. */
gboolean tinker_elf_check(const char *path, GError **error);

/* The build id that the linker wrote into the file, in hexadecimal digits; NULL where there is none. (transfer full) */
char *tinker_elf_build_id(const char *path);

#endif
