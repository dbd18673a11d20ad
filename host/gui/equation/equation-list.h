/* Equations beneath one another in a vertical box, each a row of terms, with headings, comments and values. */
#ifndef TINKER_GUI_EQUATION_LIST_H
#define TINKER_GUI_EQUATION_LIST_H

#include <gtk/gtk.h>

#include "equations/write/lines.h"
#include "gui/document/document.h"

/* Text that wraps; `text` may be NULL. */
GtkWidget *tinker_equation_label(const char *text, const char *css_class);

/* A line as it is shown, in MathML, and the same one as it is read out. */
void tinker_equation_list_add(GtkWidget *box, TinkerDocument *document, const TinkerEquationLine *shown,
                              const TinkerEquationLine *spoken);

/* See tinker_equation_row_show_values. */
void tinker_equation_list_show_values(GtkWidget *box, const TinkerModelState *state, TinkerUnitSystem units,
                                      gboolean tell);

/* All equations of a scene, and the blocks in them, as one text, without the values below them: of another text they
 * are others. (transfer full) */
char *tinker_equation_lines_written(const GPtrArray *lines, const TinkerScene *scene);

/* The values of terms that have them, of lines as they are now; NULL: none are shown. */
void tinker_equation_list_show_line_values(GtkWidget *box, const GPtrArray *lines, TinkerUnitSystem units,
                                           gboolean tell);

/* Values and headings of the lines from number `first` to before `end`, which `box` was filled with, become what these
 * lines have now, as far as they are seen on the page: what is not seen stays as it is. */
void tinker_equation_list_update(GtkWidget *box, const GPtrArray *lines, guint first, guint end);

#endif
