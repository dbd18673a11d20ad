/* Copies of scenes that are not saved, and processes that are killed while there are some. */
#ifndef TEST_COPIES_FIXTURE_H
#define TEST_COPIES_FIXTURE_H

#include "files-fixture.h"

#define COPIES_PATIENCE (30 * G_USEC_PER_SEC)

/* Files in a folder whose names end so; copies in that of this run. */
guint copies_count_in(const char *folder, const char *ending);
guint copies_count(void);

/* A process that has the scene in the file open and edited, and what ends it. `edit_until_killed` is what it does: it
 * waits for its end, as if a plugin were at work. */
void copies_edit_until_killed(const char *path);
GPid copies_start_child(const char *path);
void copies_wait_for(guint count);
void copies_kill_child(GPid pid);

/* A scene whose editor was killed before it was saved. (transfer full) */
char *copies_crash(void);
void copies_discard_all(void);

#endif
