/* Unfinished files and folders: what is written beside its place, and put there when it is whole.
 *
 * They are called ".tinker-part-" and six letters or digits. Whoever makes one holds a lock on it (flock(2)), which
 * ends with the process, however that ends. So what a killed program left can be told from what another one is just
 * writing, and is removed when something else is written into the folder. Where the file system has no locks, it stays.
 */
#ifndef TINKER_CORE_UNFINISHED_H
#define TINKER_CORE_UNFINISHED_H

#include <glib.h>

typedef struct {
    char *path; /* NULL: nothing; owned */
    int file;   /* open, and holds the lock */
} TinkerUnfinished;

/* Makes an empty file in the folder, its name ending in `ending` ("" or ".gif"); `mode` as in open(2). FALSE with
 * errno. */
gboolean tinker_unfinished_file(TinkerUnfinished *unfinished, const char *folder, const char *ending, int mode);
/* Makes an empty folder for files, without folders of its own. FALSE with errno. */
gboolean tinker_unfinished_folder(TinkerUnfinished *unfinished, const char *folder);

/* Puts it in its place by rename(2). FALSE with errno; it is still unfinished then. */
gboolean tinker_unfinished_finish(TinkerUnfinished *unfinished, const char *place);

/* Removes what is not finished, with all that is in it. */
void tinker_unfinished_clear(TinkerUnfinished *unfinished);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerUnfinished, tinker_unfinished_clear)

/* Removes what processes of this user have left unfinished in the folder when they ended. */
void tinker_unfinished_clean(const char *folder);

#endif
