/* The grammar knows no names but those that it is told, so those of a text are looked for first. */
#include "law/written-formula.h"

#include <string.h>

#include "law/typeset.h"

static const char *const letters[][2] = {
    {"alpha", "α"},  {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"zeta", "ζ"},
    {"eta", "η"},    {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
    {"xi", "ξ"},     {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},     {"phi", "φ"},
    {"chi", "χ"},    {"psi", "ψ"},   {"omega", "ω"}, {"Gamma", "Γ"},  {"Delta", "Δ"},   {"Theta", "Θ"},
    {"Lambda", "Λ"}, {"Sigma", "Σ"}, {"Phi", "Φ"},   {"Psi", "Ψ"},    {"Omega", "Ω"},
};

static gboolean begins_name(const char *at)
{
    const gunichar c = g_utf8_get_char(at);
    return c == '_' || (c < 128 ? g_ascii_isalpha((char)c) : g_unichar_isalpha(c));
}

static gsize name_length(const char *at)
{
    const char *end = at;
    while (begins_name(end) || g_ascii_isdigit(*end))
        end = g_utf8_next_char(end);
    return (gsize)(end - at);
}

/* A name with the letter in the place of its own, up to an index: "omega_0" is "ω_0". (transfer full) */
static char *with_letter(const char *name)
{
    const gsize stem = strcspn(name, "_0123456789");
    for (gsize i = 0; i < G_N_ELEMENTS(letters); i++)
        if (strlen(letters[i][0]) == stem && strncmp(letters[i][0], name, stem) == 0)
            return g_strconcat(letters[i][1], name + stem, NULL);
    return g_strdup(name);
}

/* The side with letters, and its names, ended by NULL; those before a parenthesis are functions. */
static char *take_names(const char *side, GPtrArray *names)
{
    GString *text = g_string_new(NULL);
    for (const char *at = side; *at != '\0';) {
        if (!begins_name(at)) {
            const char *next = g_utf8_next_char(at);
            g_string_append_len(text, at, next - at);
            at = next;
            continue;
        }
        const gsize length = name_length(at);
        g_autofree char *plain = g_strndup(at, length);
        char *name = with_letter(plain);
        at += length;
        g_string_append(text, name);
        if (at[strspn(at, " ")] == '(')
            g_free(name);
        else
            g_ptr_array_add(names, name);
    }
    g_ptr_array_add(names, NULL);
    return g_string_free(text, FALSE);
}

static void look_of(const char *symbol, TinkerSymbolLook *look, void *data)
{
    const char *low = strchr(symbol, '_');
    const gboolean has_index = low != NULL && low != symbol && low[1] != '\0';
    g_autofree char *stem = has_index ? g_strndup(symbol, (gsize)(low - symbol)) : NULL;
    *look = (TinkerSymbolLook){.stem = has_index ? g_intern_string(stem) : symbol, .index = has_index ? low + 1 : ""};
}

static gboolean add_side(GString *mathml, const char *side, GError **error)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new_with_free_func(g_free);
    g_autofree char *text = take_names(side, names);
    g_autoptr(TinkerExpression) tree = tinker_expression_parse(text, (const char *const *)names->pdata, error);
    if (tree == NULL) return FALSE;
    g_autofree char *typeset = tinker_expression_typeset(tree, TINKER_TYPESET_MATHML, look_of, NULL);
    g_string_append(mathml, typeset);
    return TRUE;
}

char *tinker_written_formula_mathml(const char *text, GError **error)
{
    g_autoptr(GString) mathml = g_string_new(NULL);
    for (const char *equals = tinker_expression_find_equals(text); equals != NULL;
         equals = tinker_expression_find_equals(text)) {
        g_autofree char *side = g_strndup(text, (gsize)(equals - text));
        if (!add_side(mathml, side, error)) return NULL;
        g_string_append(mathml, "<mo>=</mo>");
        text = equals + 1;
    }
    if (!add_side(mathml, text, error)) return NULL;
    return g_strdup(mathml->str);
}
