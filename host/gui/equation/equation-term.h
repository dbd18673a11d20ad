/* One term of an equation: drawn, pointed at, reached by keys, and read out. Pointing at it points at the force or the
 * block that it stands for in the document. */
#ifndef TINKER_GUI_EQUATION_TERM_H
#define TINKER_GUI_EQUATION_TERM_H

#include "gui/document/document.h"

#include <gtk/gtk.h>

#define TINKER_TYPE_EQUATION_TERM (tinker_equation_term_get_type())
G_DECLARE_FINAL_TYPE(TinkerEquationTerm, tinker_equation_term, TINKER, EQUATION_TERM, GtkWidget)

/* `mathml` as core/law writes it; `spoken` is its reading; `what` it stands for, of TINKER_NO_BLOCK: then it is no more
 * than drawn and read. Takes a reference of the document. (transfer floating) */
GtkWidget *tinker_equation_term_new(TinkerDocument *document, TinkerPointed what, const char *mathml,
                                    const char *spoken);

/* Another formula in its place, which is not read out; the term does not become narrower. */
void tinker_equation_term_set_formula(TinkerEquationTerm *term, const char *mathml);

/* Above the line that its letters stand on, px. */
double tinker_equation_term_above(TinkerEquationTerm *term);

/* Makes room for a value beneath it, or takes that away. */
void tinker_equation_term_show_value(TinkerEquationTerm *term, gboolean shown);
/* The value, as text, never cut; NULL: none is known. `last`: a later sibling, up to which it is of all together, under
 * a bracket; NULL: of this one alone. Borrowed, as long as both are there. `tell`: those who hear it are told, too. */
void tinker_equation_term_set_value(TinkerEquationTerm *term, const char *value, GtkWidget *last, gboolean tell);
/* That sibling, which is not to come into another line; NULL: there is none. */
GtkWidget *tinker_equation_term_last(TinkerEquationTerm *term);

#endif
