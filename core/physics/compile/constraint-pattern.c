/* The pattern of S = J M^-1 J^T, and the memory for it. */
#include <errno.h>
#include <glib/gi18n-lib.h>
#include <stdlib.h>

#include "physics/compile/compile-private.h"
#include "physics/compile/constraint-parts.h"
#include "physics/constraint/repeated-rows.h"

/* Beyond this many products a factorisation takes longer, and more memory, than anybody has. */
#define MOST_PRODUCTS 2e7

gpointer tinker_constraints_allot(TinkerModel *model, gsize count, gsize size)
{
    gpointer part = g_try_malloc0_n(MAX(count, 1), size);
    model->lacks_memory |= part == NULL;
    return part;
}

gboolean tinker_constraints_lack_memory(const TinkerModel *model, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY,
                _("there is no memory for the equations of %d constraints"), model->constraints.rows);
    return FALSE;
}

static gboolean list_entries_by_body(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    all->body_starts = ALLOT(model, int32_t, model->bodies + 1);
    all->body_entries = ALLOT(model, int32_t, all->entries);
    g_autofree int32_t *next = ALLOT(model, int32_t, model->bodies + 1);
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) all->body_starts[all->points[e] + 1]++;
    for (int32_t i = 0; i < model->bodies; i++)
        next[i + 1] = all->body_starts[i + 1] += all->body_starts[i];
    for (int32_t e = 0; e < all->entries; e++)
        if (all->points[e] < model->bodies) all->body_entries[next[all->points[e]]++] = e;
    return TRUE;
}

static gboolean refuse_entangled(const TinkerModel *model, GError **error)
{
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
        _("the %d constraints are so entangled that their equations do not fit into memory (use springs for some)"),
        model->constraints.rows);
    return FALSE;
}

/* The entries on each body whose products S is made of. */
typedef struct {
    const int32_t *starts, *entries;
    int32_t *own; /* what they lie in, where those are not all rows; else NULL */
} Listed;

static void listed_clear(Listed *listed)
{
    g_free(listed->own);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Listed, listed_clear)

/* Without rows that repeat others, and without hubs. */
static gboolean list_products_by_body(TinkerModel *model, Listed *listed, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    *listed = (Listed){all->body_starts, all->body_entries, NULL};
    if (all->repeats == NULL && all->hubs == NULL) return TRUE;
    listed->own = ALLOT(model, int32_t, model->bodies + 1 + all->entries);
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    int32_t *starts = listed->own, *entries = starts + model->bodies + 1, count = 0;
    for (int32_t i = 0; i < model->bodies; i++) {
        const gboolean hub = all->hubs != NULL && all->hubs[i] > 0;
        for (int32_t p = all->body_starts[i]; !hub && p < all->body_starts[i + 1]; p++)
            if (!tinker_row_repeats(all, all->row_of[all->body_entries[p]])) entries[count++] = all->body_entries[p];
        starts[i + 1] = count;
    }
    listed->starts = starts;
    listed->entries = entries;
    return TRUE;
}

/* Every two ends on one body are a product: of a hub with n rods there are n^2 / 2. */
static double count_products(const TinkerModel *model, const Listed *listed)
{
    const int32_t *starts = listed->starts;
    double products = 0;
    for (int32_t i = 0; i < model->bodies; i++)
        products += 0.5 * (starts[i + 1] - starts[i]) * (starts[i + 1] - starts[i] + 1.0);
    return products;
}

static gboolean compile_pattern(TinkerModel *model, const Listed *listed, gsize products, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    const gsize most = products + (gsize)all->hub_entry_count;
    g_autofree int *rows = ALLOT(model, int, most), *columns = ALLOT(model, int, most);
    gsize count = 0;
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = listed->starts[i]; p < listed->starts[i + 1]; p++)
            for (int32_t q = p + 1; q < listed->starts[i + 1]; q++) {
                int row = all->row_of[listed->entries[p]], column = all->row_of[listed->entries[q]];
                if (row == column) continue;
                rows[count] = row;
                columns[count++] = column;
            }
    for (int32_t k = 0; k < all->hub_entry_count; k++, count++) {
        rows[count] = all->hub_entries[k].row;
        columns[count] = all->hub_entries[k].unknown;
    }
    all->ldl = tinker_sparse_ldl_new_bordered(all->rows + all->border, all->border, rows, columns, count);
    if (all->ldl != NULL) return TRUE;
    return errno == ENOMEM ? tinker_constraints_lack_memory(model, error) : refuse_entangled(model, error);
}

static gboolean list_products(TinkerModel *model, const Listed *listed, gsize count, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    all->products = ALLOT(model, TinkerProduct, count);
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (int32_t i = 0; i < model->bodies; i++)
        for (int32_t p = listed->starts[i]; p < listed->starts[i + 1]; p++)
            for (int32_t q = p; q < listed->starts[i + 1]; q++) {
                int32_t e = listed->entries[p], f = listed->entries[q];
                double weight = model->inverse_mass[i];
                if (e != f && all->row_of[e] == all->row_of[f]) weight *= 2; /* both orders fall on the diagonal */
                all->products[all->product_count++] =
                    (TinkerProduct){tinker_sparse_ldl_slot(all->ldl, all->row_of[e], all->row_of[f]), e, f, weight};
            }
    return TRUE;
}

/* What falls on one slot stands together, so that it is added up in a register; the order within a slot is fixed, too.
 */
static int compare_products(const void *left, const void *right)
{
    const TinkerProduct *l = left, *r = right;
    if (l->slot != r->slot) return l->slot < r->slot ? -1 : 1;
    if (l->first_entry != r->first_entry) return l->first_entry < r->first_entry ? -1 : 1;
    return l->second_entry < r->second_entry ? -1 : 1;
}

/* Products of what turns a body: of every two entries there. */
static gboolean list_turn_products(TinkerModel *model, const Listed *listed, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    g_autoptr(GArray) products = g_array_new(FALSE, FALSE, sizeof(TinkerProduct));
    g_autofree int32_t *number_of = ALLOT(model, int32_t, all->entries); /* of an entry: its turn's, + 1 */
    if (model->lacks_memory) return tinker_constraints_lack_memory(model, error);
    for (int32_t k = 0; k < all->turn_count; k++)
        number_of[all->turns[k].entry] = k + 1;
    for (int32_t k = 0; k < all->turn_count; k++) {
        const int32_t entry = all->turns[k].entry, body = all->points[entry];
        if (tinker_row_repeats(all, all->turns[k].row)) continue;
        for (int32_t p = listed->starts[body]; p < listed->starts[body + 1]; p++) {
            const int32_t other = listed->entries[p];
            if (other < entry || number_of[other] == 0) continue;
            double weight = model->inverse_mass[body];
            if (other != entry && all->row_of[other] == all->row_of[entry]) weight *= 2;
            const int32_t first = 2 * all->entries + k, second = 2 * all->entries + number_of[other] - 1;
            TinkerProduct product = {tinker_sparse_ldl_slot(all->ldl, all->row_of[entry], all->row_of[other]), first,
                                     second, weight};
            g_array_append_val(products, product);
        }
    }
    qsort(products->data, products->len, sizeof(TinkerProduct), compare_products);
    all->turn_product_count = products->len;
    all->turn_products = g_memdup2(products->data, products->len * sizeof(TinkerProduct));
    return TRUE;
}

gboolean tinker_constraints_compile_pattern(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    g_auto(Listed) listed = {NULL, NULL, NULL};
    if (!list_entries_by_body(model, error)) return FALSE;
    if (!tinker_repeated_rows_find(model) || !tinker_constraints_find_hubs(model))
        return tinker_constraints_lack_memory(model, error);
    tinker_constraints_list_hubs(model);
    if (!list_products_by_body(model, &listed, error)) return FALSE;
    const double products = count_products(model, &listed);
    if (products > MOST_PRODUCTS) return refuse_entangled(model, error);
    if (!compile_pattern(model, &listed, (gsize)products, error)) return FALSE;
    if (!list_products(model, &listed, (gsize)products, error)) return FALSE;
    tinker_repeated_rows_place(all);
    tinker_constraints_place_hubs(model);
    qsort(all->products, all->product_count, sizeof(TinkerProduct), compare_products);
    return all->turn_count == 0 || list_turn_products(model, &listed, error);
}
