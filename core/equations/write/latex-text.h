/* Plain text within LaTeX. */
#ifndef TINKER_CORE_EQUATIONS_LATEX_TEXT_H
#define TINKER_CORE_EQUATIONS_LATEX_TEXT_H

/* What a document begins with, up to and with \begin{document}: it is set by pdfLaTeX as well as by LuaLaTeX. Static.
 */
extern const char tinker_latex_head[];

/* Around a formula that stands in a plain text and is LaTeX already. */
#define TINKER_LATEX_FORMULA "\002"
#define TINKER_LATEX_TEXT    "\003"

/* Every letter of any text stands for itself, or in pdfLaTeX, which has European ones alone, as a question mark.
 * (transfer full) */
char *tinker_latex_text(const char *text);

/* In points, about. */
double tinker_latex_text_width(const char *text);

#endif
