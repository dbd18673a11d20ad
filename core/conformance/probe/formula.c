/* A formula is text for people; what is found in it are its words. "T = k (L - L0) + c dL/dt" has T, k, L, L0, c, dL,
 * dt. */
#include "conformance/probe/formula.h"

#include <string.h>

#define PROSE 4 /* letters */

/* What stands for itself in a law of a block: kinematics, forces, energies, indices, and functions of three letters. */
static const char *const own[] = {"L",   "d",   "r",   "n",   "x",   "y",   "v",   "a",   "t",   "q",   "g",   "e",
                                  "F",   "f",   "T",   "M",   "N",   "W",   "P",   "V",   "E",   "m",   "J",   "i",
                                  "j",   "o",   "λ",   "θ",   "φ",   "α",   "ψ",   "π",   "pi",  "sin", "cos", "tan",
                                  "exp", "log", "ln",  "abs", "max", "min", "pow", "sgn", "mod", "dot", "div", "rot",
                                  "erf", "arg", "cot", "sec", "csc", "if",  "or",  "and", "of",  "at",  "in",  "is",
                                  "to",  "for", "all", "sum", "the", "not", NULL};

static gboolean is_letter(gunichar c)
{
    return g_unichar_isalpha(c) || c == '_';
}

static gboolean is_part(gunichar c)
{
    return is_letter(c) || g_unichar_isdigit(c);
}

gboolean kit_formula_has_word(const char *text, const char *word)
{
    for (const char *at = strstr(text, word); at != NULL; at = strstr(at + 1, word)) {
        const char *before = at == text ? NULL : g_utf8_find_prev_char(text, at);
        const char *behind = at + strlen(word);
        if ((before == NULL || !is_part(g_utf8_get_char(before))) && !is_part(g_utf8_get_char(behind))) return TRUE;
    }
    return FALSE;
}

/* The next word from *at on, which is moved behind it; NULL at the end. What begins with a digit is a number. (transfer
 * full) */
static char *next_word(const char **at)
{
    while (**at != '\0') {
        const char *begin = *at;
        while (is_part(g_utf8_get_char(*at)))
            *at = g_utf8_next_char(*at);
        if (begin == *at)
            *at = g_utf8_next_char(*at);
        else if (is_letter(g_utf8_get_char(begin)))
            return g_strndup(begin, (gsize)(*at - begin));
    }
    return NULL;
}

static gboolean is_prose(const char *word)
{
    for (const char *p = word; *p != '\0'; p++)
        if (!g_ascii_islower(*p)) return FALSE;
    return strlen(word) >= PROSE;
}

/* "Hooke": a capital and small letters. */
static gboolean is_name(const char *word)
{
    return g_ascii_isupper(word[0]) && is_prose(word + 1);
}

static gboolean is_listed(const char *word, const char *const *symbols)
{
    return g_strv_contains(own, word) || g_strv_contains(symbols, word);
}

/* Itself, an index or a component of what is listed ("x1", "F_a", "vx"), or a differential ("dL"). */
static gboolean is_known(const char *word, const char *const *symbols)
{
    if (is_listed(word, symbols) || is_prose(word) || is_name(word)) return TRUE;
    if (word[0] == 'd' && is_listed(word + 1, symbols)) return TRUE;
    if (g_str_has_prefix(word, "Δ") || g_str_has_prefix(word, "δ")) return is_known(word + strlen("Δ"), symbols);
    g_autofree char *stem = g_strdup(word);
    char *index = strchr(stem, '_');
    if (index != NULL) *index = '\0';
    for (gsize end = strlen(stem); end > 0 && g_ascii_isdigit(stem[end - 1]); end--)
        stem[end - 1] = '\0';
    if (is_listed(stem, symbols) || is_prose(stem)) return TRUE;
    const gsize length = strlen(stem);
    if (length > 1 && strchr("xy", stem[length - 1]) != NULL) stem[length - 1] = '\0';
    return is_listed(stem, symbols);
}

/* What stands alone before an equals sign is defined there: the words of each left-hand side that has but one unknown
 * one. (transfer full) */
static GPtrArray *defined_by(const char *formula, const char *const *symbols)
{
    GPtrArray *all = g_ptr_array_new_with_free_func(g_free);
    for (const char *const *symbol = symbols; *symbol != NULL; symbol++)
        g_ptr_array_add(all, g_strdup(*symbol));
    int depth = 0;
    const char *begin = formula;
    for (const char *p = formula; *p != '\0'; p++) {
        depth += *p == '(' ? 1 : *p == ')' ? -1 : 0;
        if ((*p == ',' || *p == ';') && depth == 0) begin = p + 1;
        if (*p != '=') continue;
        g_autofree char *left = g_strndup(begin, (gsize)(p - begin)), *only = NULL;
        const char *at = left;
        int unknown = 0;
        for (char *word = next_word(&at); word != NULL; word = next_word(&at)) {
            if (is_known(word, symbols)) {
                g_free(word);
                continue;
            }
            unknown++;
            g_free(only);
            only = word;
        }
        if (unknown == 1) g_ptr_array_add(all, g_steal_pointer(&only));
    }
    g_ptr_array_add(all, NULL);
    return all;
}

char *kit_formula_unknown(const char *formula, const char *const *symbols)
{
    g_autoptr(GPtrArray) defined = defined_by(formula, symbols);
    const char *at = formula;
    for (char *word = next_word(&at); word != NULL; word = next_word(&at)) {
        if (!is_known(word, (const char *const *)defined->pdata)) return word;
        g_free(word);
    }
    return NULL;
}
