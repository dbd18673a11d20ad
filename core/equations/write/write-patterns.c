/* A matrix too large to be written: what its entries look like without their numbers, "2 k on the diagonal, -k beside
 * it", how many there are of each, and their values. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "equations/write/page-private.h"
#include "law/build.h"

#define MOST_KINDS 6    /* that are told apart */
#define SAME       1e-9 /* of a value, between those that are one */

const char *const page_matrix_letters[TINKER_MATRICES] = {"M", "C", "K"};

/* Entries that look alike, so far from the diagonal. */
typedef struct {
    char *text;
    guint off, count;
    double least, most;
} Kind;

typedef struct {
    TinkerPage *page;
    GArray *kinds;    /* of Kind, */
    GHashTable *find; /* text to number + 1 in `kinds` */
    guint count, band;
} Pattern;

static void kind_clear(gpointer data)
{
    g_free(((Kind *)data)->text);
}

/* A symbol without its number, "k" of k_1. */
static void look_of_stem(const char *symbol, TinkerSymbolLook *look, void *data)
{
    tinker_equations_look(symbol, look, data);
    look->index = "";
}

static char *stem_text(const TinkerPage *page, const TinkerExpression *part)
{
    return tinker_expression_typeset(part, page->format, look_of_stem, (void *)page->equations);
}

/* What is added several times, once with a factor: k_1 + k_2 is 2 k. (transfer full) */
static TinkerExpression *gathered(const TinkerPage *page, const TinkerExpression *sum)
{
    g_autoptr(GPtrArray) texts = g_ptr_array_new_with_free_func(g_free);
    TinkerExpression *all = tinker_expression_number(0);
    for (int i = 0; i < sum->count; i++)
        g_ptr_array_add(texts, stem_text(page, sum->parts[i]));
    for (int i = 0; i < sum->count; i++) {
        int count = 0, first = -1;
        for (int k = 0; k < sum->count; k++) {
            if (!g_str_equal(texts->pdata[k], texts->pdata[i])) continue;
            if (first < 0) first = k;
            count++;
        }
        if (first != i) continue;
        TinkerExpression *one = tinker_expression_ref(sum->parts[i]);
        all = tinker_expression_plus(all,
                                     count > 1 ? tinker_expression_times(tinker_expression_number(count), one) : one);
    }
    return all;
}

/* (transfer full) */
static char *entry_text(const TinkerPage *page, const TinkerExpression *entry)
{
    if (entry->kind != TINKER_EXPRESSION_SUM) return stem_text(page, entry);
    g_autoptr(TinkerExpression) short_sum = gathered(page, entry);
    return stem_text(page, short_sum);
}

static void add_entry(guint row, guint column, const TinkerExpression *entry, void *data)
{
    Pattern *pattern = data;
    const guint off = row > column ? row - column : column - row;
    const double value = tinker_equations_value(pattern->page->equations, entry);
    g_autofree char *text = entry_text(pattern->page, entry);
    char *key = g_strdup_printf("%u %s", off, text);
    guint number = GPOINTER_TO_UINT(g_hash_table_lookup(pattern->find, key));
    if (number == 0) {
        const Kind kind = {g_steal_pointer(&text), off, 0, value, value};
        g_array_append_val(pattern->kinds, kind);
        number = pattern->kinds->len;
        g_hash_table_insert(pattern->find, g_steal_pointer(&key), GUINT_TO_POINTER(number));
    }
    g_free(key);
    Kind *kind = &g_array_index(pattern->kinds, Kind, number - 1);
    kind->count++;
    kind->least = fmin(kind->least, value);
    kind->most = fmax(kind->most, value);
    pattern->count++;
    pattern->band = MAX(pattern->band, off);
}

/* By the way from the diagonal, then the most frequent first. */
static int in_order(const void *left, const void *right)
{
    const Kind *l = left, *r = right;
    if (l->off != r->off) return l->off < r->off ? -1 : 1;
    return l->count != r->count ? (l->count > r->count ? -1 : 1) : strcmp(l->text, r->text);
}

/* "K is tridiagonal, 1000 by 1000, with 2998 entries". (transfer full) */
static char *shape_of(const Pattern *pattern, TinkerMatrixKind kind, guint n)
{
    const char *name = page_matrix_letters[kind];
    if (pattern->count == 0) return g_strdup_printf(_("%s is 0"), name);
    if (pattern->band == 0)
        return g_strdup_printf(_("%s is diagonal, %u × %u, with %u entries"), name, n, n, pattern->count);
    if (pattern->band == 1)
        return g_strdup_printf(_("%s is tridiagonal, %u × %u, with %u entries"), name, n, n, pattern->count);
    return g_strdup_printf(_("%s is %u × %u, with %u entries, none farther than %u from the diagonal"), name, n, n,
                           pattern->count, pattern->band);
}

/* K with "i, i" or "i, i ± 2" beneath it. (transfer full) */
static char *entry_name(const TinkerPage *page, TinkerMatrixKind kind, guint off)
{
    g_autofree char *index = off == 0 ? g_strdup("i,i") : g_strdup_printf("i,i±%u", off);
    return tinker_page_written(page, page_matrix_letters[kind], index, 0);
}

/* With a minus as it is printed. (transfer full) */
static char *quantity(double value, TinkerDimension dimension)
{
    g_autofree char *size = tinker_quantity_brief(fabs(value), dimension, TINKER_UNIT_SYSTEM_SI);
    return g_strconcat(value < 0 ? "−" : "", size, NULL);
}

/* "998 of 1000, 200 N/m", or between which values. (transfer full) */
static char *comment_of(const TinkerPage *page, const Kind *kind, guint places, TinkerDimension dimension)
{
    g_autofree char *least = quantity(kind->least, dimension), *most = quantity(kind->most, dimension);
    const gboolean same = fabs(kind->most - kind->least) <= SAME * fmax(fabs(kind->most), fabs(kind->least));
    const char *where = kind->off == 0 ? _("on the diagonal") : kind->off == 1 ? _("beside it") : _("farther off");
    g_autofree char *values = same ? g_strdup(most) : g_strdup_printf(_("%s to %s"), least, most);
    if (kind->count == places) return g_strdup_printf("%s, %s", where, values);
    return g_strdup_printf(_("%s, %u of %u, %s"), where, kind->count, places, values);
}

void tinker_page_pattern(TinkerPage *page, const TinkerMatrixIsland *island, TinkerMatrixKind kind)
{
    static const TinkerDimension dimensions[TINKER_MATRICES] = {{1, 0, 0, 0}, {1, 0, -1, 0}, {1, 0, -2, 0}};
    const guint n = island->coordinates->len;
    Pattern pattern = {page, g_array_new(FALSE, TRUE, sizeof(Kind)),
                       g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL), 0, 0};
    g_array_set_clear_func(pattern.kinds, kind_clear);
    tinker_matrix_each(island, kind, add_entry, &pattern);
    g_array_sort(pattern.kinds, in_order);
    g_autofree char *shape = shape_of(&pattern, kind, n);
    tinker_page_heading(page, shape);
    for (guint i = 0; i < MIN(pattern.kinds->len, MOST_KINDS); i++) {
        const Kind *each = &g_array_index(pattern.kinds, Kind, i);
        const guint places = each->off == 0 ? n : 2 * (n - each->off);
        tinker_page_equation(page, entry_name(page, kind, each->off), g_strdup(each->text),
                             comment_of(page, each, places, dimensions[kind]));
    }
    if (pattern.kinds->len > MOST_KINDS) {
        g_autofree char *more = g_strdup_printf(_("and %u other kinds of entries"), pattern.kinds->len - MOST_KINDS);
        tinker_page_heading(page, more);
    }
    g_hash_table_unref(pattern.find);
    g_array_unref(pattern.kinds);
}
