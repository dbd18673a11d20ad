/* What the program remembers between its runs, in tinker/window.ini of the user's configuration folder. No widget.
 *
 * A key file and no schema of the desktop's, so that the program runs from where it was built. What cannot be read has
 * its default; what cannot be written is forgotten. */
#ifndef TINKER_GUI_SETTINGS_H
#define TINKER_GUI_SETTINGS_H

#include <glib.h>

/* From now on neither reads nor writes: for pictures, which must not depend on the user. */
void tinker_settings_disable(void);

int tinker_settings_integer(const char *group, const char *key, int otherwise);
gboolean tinker_settings_switch(const char *group, const char *key, gboolean otherwise);
/* (transfer full) */
char *tinker_settings_text(const char *group, const char *key, const char *otherwise);

void tinker_settings_set_integer(const char *group, const char *key, int value);
void tinker_settings_set_switch(const char *group, const char *key, gboolean value);
void tinker_settings_set_text(const char *group, const char *key, const char *value);

/* Writes what was set. */
void tinker_settings_store(void);

#endif
