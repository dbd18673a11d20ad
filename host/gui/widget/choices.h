/* Drop-down lists of texts that may be long, as names are. */
#ifndef TINKER_GUI_CHOICES_H
#define TINKER_GUI_CHOICES_H

#include <gtk/gtk.h>

/* From now on, choices of this list of strings are cut off in its button where it has no room for them, so that none of
 * them makes the window wider. The list that opens shows more of them. */
void tinker_choices_cut_off(GtkDropDown *list);

#endif
