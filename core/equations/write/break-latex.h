/* Lines of LaTeX that fit on the paper. */
#ifndef TINKER_CORE_EQUATIONS_BREAK_LATEX_H
#define TINKER_CORE_EQUATIONS_BREAK_LATEX_H

#include <glib.h>

/* About how wide a formula is in points, of letters of 10 points; rather too wide than too narrow. */
double tinker_latex_width(const char *formula);

/* Cuts a formula of math mode before a plus, minus or equals sign wherever it would be wider than `most` points;
 * within brackets only where nothing outside them will do: those are then closed and opened by invisible ones. What has
 * no such sign stays as wide as it is. Element: char *. (transfer full) */
GPtrArray *tinker_latex_lines(const char *formula, double most);

#endif
