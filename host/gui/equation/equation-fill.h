/* Rows of equations that are made a few at a time: a large scene has hundreds of terms, each a widget, and no key or
 * frame waits for them all. */
#ifndef TINKER_GUI_EQUATION_FILL_H
#define TINKER_GUI_EQUATION_FILL_H

#include "gui/equation/equation-list.h"

typedef struct TinkerEquationFill TinkerEquationFill;

typedef void (*TinkerFilledFunc)(gpointer data);

/* `done` is called when all lines of a start are shown, at once where they are few. (transfer full) */
TinkerEquationFill *tinker_equation_fill_new(TinkerDocument *document, TinkerFilledFunc done, gpointer data);

/* Adds these lines, as they are shown and as they are read out, the first `row_count` to `rows` and the others to
 * `rest`. The boxes outlive it, or it is stopped before. Takes the arrays over. */
void tinker_equation_fill_start(TinkerEquationFill *fill, GtkWidget *rows, GtkWidget *rest, guint row_count,
                                GPtrArray *shown, GPtrArray *spoken);

/* Whether lines are still to come. */
gboolean tinker_equation_fill_is_going(const TinkerEquationFill *fill);

/* The lines that are to come do not. */
void tinker_equation_fill_stop(TinkerEquationFill *fill);

void tinker_equation_fill_free(TinkerEquationFill *fill);

G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerEquationFill, tinker_equation_fill_free)

#endif
