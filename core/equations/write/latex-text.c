#include "equations/write/latex-text.h"

#include <glib.h>
#include <string.h>

#include "equations/write/break-latex.h"
#include "law/typeset.h"

#define LETTER 5.6 /* points, of a text's */

/* pdfLaTeX has an encoding of letters, and hyphens in them; LuaLaTeX has all letters. Both have fonts with outlines. */
const char tinker_latex_head[] = "\\documentclass[a4paper,fleqn]{article}\n"
                                 "\\ifdefined\\pdftexversion\n\\usepackage[utf8]{inputenc}\n\\usepackage[T1]{fontenc}\n"
                                 "\\IfFileExists{lmodern.sty}{\\usepackage{lmodern}}{}\n\\fi\n"
                                 "\\newcommand\\letter[1]{\\ifdefined\\pdftexversion?\\else#1\\fi}\n"
                                 "\\usepackage{amsmath,graphicx}\n\\usepackage[margin=20mm,landscape]{geometry}\n"
                                 "\\setlength{\\mathindent}{1em}\n\\allowdisplaybreaks\n\\begin{document}\n";

/* Signs that stand in formulas alone; NULL: none. Static. */
static const char *sign_of(gunichar letter)
{
    static const struct {
        gunichar letter;
        const char *is;
    } signs[] = {{0x2212, "-"},        {0x00b7, "\\cdot"},  {0x2264, "\\le"}, {0x2265, "\\ge"},
                 {0x2260, "\\ne"},     {0x2192, "\\to"},    {0x00b1, "\\pm"}, {0x00d7, "\\times"},
                 {0x2248, "\\approx"}, {0x221e, "\\infty"}, {0x2208, "\\in"}, {0x2206, "\\Delta"},
                 {0x2190, "\\gets"},   {0x00b2, "^2"},      {0x00b3, "^3"},   {0x2194, "\\leftrightarrow"}};
    for (gsize i = 0; i < G_N_ELEMENTS(signs); i++)
        if (signs[i].letter == letter) return signs[i].is;
    return NULL;
}

/* Latin with its accents, and the signs of print: what the encoding T1 and textcomp have. */
static gboolean is_european(gunichar letter)
{
    static const gunichar print[] = {0x2013, 0x2014, 0x2018, 0x2019, 0x201a, 0x201c, 0x201d, 0x201e,
                                     0x2020, 0x2022, 0x2026, 0x2030, 0x2039, 0x203a, 0x20ac, 0x2122};
    for (gsize i = 0; i < G_N_ELEMENTS(print); i++)
        if (print[i] == letter) return TRUE;
    static const gunichar missing[] = {0x0126, 0x0127, 0x0138, 0x013f, 0x0140, 0x0149, 0x0166, 0x0167};
    for (gsize i = 0; i < G_N_ELEMENTS(missing); i++)
        if (missing[i] == letter) return FALSE;
    return letter >= 0xa0 && letter < 0x180;
}

static void put_foreign(GString *safe, const char *at, gunichar letter)
{
    char own[8] = "";
    memcpy(own, at, (gsize)(g_utf8_next_char(at) - at));
    const char *sign = sign_of(letter), *greek = tinker_greek_name(own);
    if (sign != NULL)
        g_string_append_printf(safe, "$%s$", sign);
    else if (letter >= 0x2080 && letter <= 0x2089)
        g_string_append_printf(safe, "$_%d$", (int)(letter - 0x2080));
    else if (greek != NULL && letter != 0xb5)
        g_string_append_printf(safe, "$\\%s$", greek);
    else
        g_string_append_printf(safe, is_european(letter) ? "%s" : "\\letter{%s}", own);
}

static void put_letter(GString *safe, char letter)
{
    if (strchr("#$%&_{}", letter) != NULL)
        g_string_append_printf(safe, "\\%c", letter);
    else if (letter == '\\')
        g_string_append(safe, "\\textbackslash{}");
    else if (letter == '^' || letter == '~')
        g_string_append_printf(safe, "\\%c{}", letter);
    else if (!g_ascii_iscntrl(letter))
        g_string_append_c(safe, letter);
}

char *tinker_latex_text(const char *text)
{
    GString *safe = g_string_new(NULL);
    gboolean formula = FALSE;
    for (const char *p = text; *p != '\0'; p = g_utf8_next_char(p)) {
        if (*p == TINKER_LATEX_FORMULA[0] || *p == TINKER_LATEX_TEXT[0]) {
            formula = *p == TINKER_LATEX_FORMULA[0];
            g_string_append_c(safe, '$');
        } else if (formula) {
            g_string_append_len(safe, p, g_utf8_next_char(p) - p);
        } else if ((guchar)*p >= 0x80) {
            put_foreign(safe, p, g_utf8_get_char(p));
        } else {
            put_letter(safe, *p);
        }
    }
    return g_string_free(safe, FALSE);
}

double tinker_latex_text_width(const char *text)
{
    g_auto(GStrv) parts = g_strsplit(text, TINKER_LATEX_FORMULA, -1);
    double width = LETTER * (double)g_utf8_strlen(parts[0] != NULL ? parts[0] : "", -1);
    for (int i = 1; parts[0] != NULL && parts[i] != NULL; i++) {
        char *behind = strstr(parts[i], TINKER_LATEX_TEXT);
        if (behind != NULL) *behind++ = '\0';
        width += tinker_latex_width(parts[i]) + (behind != NULL ? LETTER * (double)g_utf8_strlen(behind, -1) : 0);
    }
    return width;
}
