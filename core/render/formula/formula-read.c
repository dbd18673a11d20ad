/* MathML to nodes. */
#include "render/formula/formula-private.h"

#include <string.h>

static const struct {
    const char *element;
    FormulaKind kind;
    guint parts; /* that it has; 0: any number */
    gboolean text;
} elements[] = {
    {"mrow", FORMULA_ROW, 0, FALSE},       {"math", FORMULA_ROW, 0, FALSE},      {"mi", FORMULA_LETTER, 0, TRUE},
    {"mn", FORMULA_DIGITS, 0, TRUE},       {"mo", FORMULA_SIGN, 0, TRUE},        {"mtext", FORMULA_WORDS, 0, TRUE},
    {"mfrac", FORMULA_FRACTION, 2, FALSE}, {"msup", FORMULA_POWER, 2, FALSE},    {"msub", FORMULA_INDEX, 2, FALSE},
    {"msqrt", FORMULA_ROOT, 0, FALSE},     {"mover", FORMULA_ACCENT, 2, FALSE},  {"mtable", FORMULA_TABLE, 0, FALSE},
    {"msubsup", FORMULA_BOTH, 3, FALSE},   {"mtr", FORMULA_TABLE_ROW, 0, FALSE}, {"mtd", FORMULA_CELL, 0, FALSE},
};

static FormulaNode *node_new(FormulaKind kind)
{
    FormulaNode *node = g_new0(FormulaNode, 1);
    node->kind = kind;
    node->text = g_strdup("");
    node->parts = g_ptr_array_new_with_free_func((GDestroyNotify)formula_node_free);
    return node;
}

void formula_node_free(FormulaNode *node)
{
    g_free(node->text);
    g_ptr_array_unref(node->parts);
    g_free(node);
}

static gsize element_number(const char *name)
{
    gsize i = 0;
    while (i < G_N_ELEMENTS(elements) && strcmp(elements[i].element, name) != 0)
        i++;
    return i;
}

static void on_start(GMarkupParseContext *context, const char *name, const char **attributes, const char **values,
                     gpointer data, GError **error)
{
    GPtrArray *open = data;
    const gsize number = element_number(name);
    if (number == G_N_ELEMENTS(elements)) {
        g_set_error(error, G_MARKUP_ERROR, G_MARKUP_ERROR_UNKNOWN_ELEMENT,
                    "a formula cannot have <%s> (it may have mrow, mi, mn, mo, mfrac, msup, msub, msqrt, ...)", name);
        return;
    }
    FormulaNode *node = node_new(elements[number].kind), *parent = g_ptr_array_index(open, open->len - 1);
    g_ptr_array_add(parent->parts, node);
    g_ptr_array_add(open, node);
}

static void on_end(GMarkupParseContext *context, const char *name, gpointer data, GError **error)
{
    GPtrArray *open = data;
    const gsize number = element_number(name);
    const FormulaNode *node = g_ptr_array_index(open, open->len - 1);
    if (elements[number].parts != 0 && node->parts->len != elements[number].parts)
        g_set_error(error, G_MARKUP_ERROR, G_MARKUP_ERROR_INVALID_CONTENT, "<%s> needs %u parts, not %u", name,
                    elements[number].parts, node->parts->len);
    g_ptr_array_set_size(open, (int)open->len - 1);
}

static void on_text(GMarkupParseContext *context, const char *text, gsize length, gpointer data, GError **error)
{
    GPtrArray *open = data;
    FormulaNode *node = g_ptr_array_index(open, open->len - 1);
    const gboolean takes = node->kind == FORMULA_LETTER || node->kind == FORMULA_DIGITS || node->kind == FORMULA_SIGN ||
                           node->kind == FORMULA_WORDS;
    if (!takes) return; /* white space between elements */
    g_autofree char *more = g_strndup(text, length), *before = node->text;
    node->text = g_strconcat(before, more, NULL);
}

FormulaNode *formula_read(const char *mathml, GError **error)
{
    static const GMarkupParser parser = {.start_element = on_start, .end_element = on_end, .text = on_text};
    FormulaNode *root = node_new(FORMULA_ROW);
    g_autoptr(GPtrArray) open = g_ptr_array_new();
    g_ptr_array_add(open, root);
    GMarkupParseContext *context = g_markup_parse_context_new(&parser, 0, open, NULL);
    g_autofree char *whole = g_strconcat("<mrow>", mathml, "</mrow>", NULL);
    const gboolean done =
        g_markup_parse_context_parse(context, whole, -1, error) && g_markup_parse_context_end_parse(context, error);
    g_markup_parse_context_free(context);
    if (done) return root;
    formula_node_free(root);
    return NULL;
}
