/* The matrix form as a page. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "equations/write/page-private.h"
#include "equations/write/write.h"
#include "law/build.h"

#define ROUNDING     1e-12 /* damping ratios below it are 0 */
#define MOST_WRITTEN 8     /* coordinates: beyond, patterns */

static const TinkerDimension frequency = {0, 0, -1, 1}, seconds = {0, 0, 1, 0};

/* Of places along lines, and of angles. */
static const struct {
    TinkerDimension place, matrices[TINKER_MATRICES], load;
} dimensions[] = {{{0, 1, 0, 0}, {{1, 0, 0, 0}, {1, 0, -1, 0}, {1, 0, -2, 0}}, {1, 1, -2, 0}},
                  {{0, 0, 0, 1}, {{1, 2, 0, 0}, {1, 2, -1, -1}, {1, 2, -2, -1}}, {1, 2, -2, 0}}};

static const TinkerMatrixCoordinate *coordinate_at(const TinkerMatrixIsland *island, guint number)
{
    return &g_array_index(island->coordinates, TinkerMatrixCoordinate, number);
}

/* q or q_1, with dots. */
static char *coordinate(const TinkerPage *page, const TinkerMatrixIsland *island, guint number, int dots)
{
    g_autofree char *index = island->coordinates->len == 1 ? g_strdup("") : g_strdup_printf("%u", number + 1);
    return tinker_page_written(page, "q", index, dots);
}

/* "+ c q'" where the coefficient is not 0. */
static void add_term(GString *sum, const TinkerPage *page, const TinkerExpression *factor, char *variable)
{
    if (!tinker_expression_is_number(factor, 0)) {
        const gboolean negative = factor->kind == TINKER_EXPRESSION_NEGATIVE;
        const TinkerExpression *size = negative ? factor->parts[0] : factor;
        g_autofree char *text = tinker_page_factor(page, size);
        if (sum->len > 0 || negative) g_string_append(sum, tinker_typeset_sign(page->format, negative ? '-' : '+'));
        g_string_append_printf(sum, "%s%s%s", text, tinker_typeset_sign(page->format, '*'), variable);
    }
    g_free(variable);
}

/* Row i: m q'' + c q' + k q = f. */
static void write_row(TinkerPage *page, const TinkerMatrixIsland *island, guint i)
{
    const guint n = island->coordinates->len;
    GString *sum = g_string_new(NULL);
    for (int order = 0; order < 3; order++)
        for (guint k = 0; k < n; k++)
            add_term(sum, page, g_ptr_array_index(island->matrices[order], i * n + k),
                     coordinate(page, island, k, 2 - order));
    tinker_page_equation(page, g_string_free(sum, FALSE),
                         tinker_page_expression(page, g_ptr_array_index(island->load, i)), NULL);
}

/* From where it is counted from, without what rounding leaves. */
static double place_now(const TinkerPage *page, const TinkerMatrixCoordinate *each)
{
    const double value = tinker_equations_value(page->equations, each->is) - each->about;
    return fabs(value) <= each->rounding + tinker_equations_rounding(page->equations, each->is) ? 0 : value;
}

static void write_coordinate(TinkerPage *page, const TinkerMatrixIsland *island, guint number)
{
    const TinkerMatrixCoordinate *each = coordinate_at(island, number);
    g_autofree char *is = tinker_page_expression(page, each->is);
    const double rest = fabs(each->about) <= each->rounding ? 0 : each->about;
    const TinkerDimension place = dimensions[each->turning].place;
    g_autofree char *about = tinker_page_quantity(page, fabs(rest), place);
    char *right = rest == 0 ? g_strdup(is)
                            : g_strconcat(is, tinker_typeset_sign(page->format, rest > 0 ? '-' : '+'), about, NULL);
    tinker_page_equation(page, coordinate(page, island, number, 0), right,
                         g_strdup(island->about_rest ? _("counted from rest")
                                  : each->turning    ? _("its angle")
                                                     : _("its place")));
    tinker_page_equation(page, coordinate(page, island, number, 0),
                         tinker_page_quantity(page, place_now(page, each), place),
                         g_strdup_printf(C_("equations", "at t = %g s"), page->equations->time));
}

/* The index of a root's ω; where a block has one with it, as a motor its frequency, with a 0 before. (transfer full) */
static char *natural_index(const TinkerPage *page, const char *index)
{
    g_autofree char *free = tinker_equations_free_index(page->equations, TINKER_NO_BLOCK, "ω", index, 0, NULL);
    return strcmp(free, index) == 0 ? g_strdup(index) : g_strconcat("0,", index, NULL);
}

static char *natural_name(const TinkerPage *page, const char *index)
{
    g_autofree char *own = natural_index(page, index);
    return tinker_page_written(page, "ω", own, 0);
}

/* The textbook's form of one coordinate: q'' + 2 ζ ω q' + ω^2 q = f / m. */
static void write_second_order(TinkerPage *page, const TinkerMatrixIsland *island)
{
    const double omega = island->omega[0], zeta = island->zeta[0];
    const char *times = tinker_typeset_sign(page->format, '*'), *plus = tinker_typeset_sign(page->format, '+');
    if (!(omega > 0) || isnan(zeta)) return;
    GString *sum = g_string_new(NULL);
    g_autofree char *q = coordinate(page, island, 0, 0), *speed = coordinate(page, island, 0, 1);
    g_autofree char *acceleration = coordinate(page, island, 0, 2);
    g_autofree char *ratio = tinker_page_written(page, "ζ", "", 0), *natural = natural_name(page, "0");
    g_autofree char *index = natural_index(page, "0");
    g_autofree char *square = tinker_symbol_squared(&(TinkerSymbolLook){.stem = "ω", .index = index}, page->format);
    g_autoptr(TinkerExpression) two = tinker_expression_number(2);
    g_autofree char *number = tinker_page_expression(page, two);
    g_string_append(sum, acceleration);
    if (fabs(zeta) >= ROUNDING)
        g_string_append_printf(sum, "%s%s%s%s%s%s%s%s", plus, number, times, ratio, times, natural, times, speed);
    g_string_append_printf(sum, "%s%s%s%s", plus, square, times, q);
    g_autoptr(TinkerExpression) load =
        tinker_expression_over(tinker_expression_ref(g_ptr_array_index(island->load, 0)),
                               tinker_expression_ref(g_ptr_array_index(island->matrices[TINKER_MATRIX_MASS], 0)));
    tinker_page_equation(page, g_string_free(sum, FALSE), tinker_page_expression(page, load), NULL);
}

/* By which pairs of roots are ordered: the larger of the two; 0: nothing brings it back. */
static double root_size(const TinkerMatrixIsland *island, guint pair)
{
    const double omega = island->omega[pair], zeta = fabs(island->zeta[pair]);
    if (isnan(omega)) return fmax(fabs(island->unstable[2 * pair]), fabs(island->unstable[2 * pair + 1]));
    return zeta > 1 ? omega * (zeta + sqrt(zeta * zeta - 1)) : omega;
}

/* Where a pair stands among those of all islands, from 1: so modes are numbered (analysis/modes/modes.h), too. */
static guint pair_number(const TinkerMatrixForm *form, const TinkerMatrixIsland *island, guint pair)
{
    const double size = root_size(island, pair);
    gboolean is_before = TRUE; /* in the form */
    guint number = 1;
    for (guint i = 0; i < form->islands->len; i++) {
        const TinkerMatrixIsland *each = g_ptr_array_index(form->islands, i);
        for (guint k = 0; k < each->coordinates->len; k++) {
            if (each == island && k == pair) is_before = FALSE;
            const double other = root_size(each, k);
            if (other > 0 && (other < size || (other == size && is_before))) number++;
        }
    }
    return number;
}

static void write_roots(TinkerPage *page, const TinkerMatrixForm *form, const TinkerMatrixIsland *island)
{
    static const TinkerDimension pure = {0, 0, 0, 0}, rate = {0, 0, -1, 0};
    const guint n = island->coordinates->len;
    if (n == 1) write_second_order(page, island);
    for (guint i = 0; i < n; i++) {
        const double omega = island->omega[i], zeta = fabs(island->zeta[i]) < ROUNDING ? 0 : island->zeta[i];
        g_autofree char *index = n == 1       ? g_strdup("0")
                                 : omega == 0 ? g_strdup("")
                                              : g_strdup_printf("%u", pair_number(form, island, i));
        if (isnan(omega)) {
            tinker_page_equation(
                page, tinker_page_written(page, "s", index, 0),
                tinker_page_quantity(page, fmax(island->unstable[2 * i], island->unstable[2 * i + 1]), rate),
                g_strdup(_("it is not stable: so fast it leaves its rest")));
            continue;
        }
        tinker_page_equation(page, natural_name(page, index), tinker_page_quantity(page, omega, frequency),
                             g_strdup(omega > 0 ? _("natural frequency") : _("nothing brings it back")));
        if (omega == 0 && !isnan(island->decay[i]))
            tinker_page_equation(page, tinker_page_written(page, "s", index, 0),
                                 tinker_page_quantity(page, -island->decay[i], rate),
                                 g_strdup(island->decay[i] > 0 ? _("so fast its speed dies away")
                                                               : _("it is not stable: so fast its speed grows")));
        if (!isnan(zeta))
            tinker_page_equation(page, tinker_page_written(page, "ζ", n == 1 ? "" : index, 0),
                                 tinker_page_quantity(page, zeta, pure),
                                 g_strdup(zeta == 0  ? _("damping ratio: none")
                                          : zeta < 1 ? _("damping ratio: its swings die away")
                                                     : _("damping ratio: it creeps back")));
        if (!isnan(zeta) && fabs(zeta) < 1)
            tinker_page_equation(page, tinker_page_written(page, "T", n == 1 ? "" : index, 0),
                                 tinker_page_quantity(page, 2 * G_PI / (omega * sqrt(1 - zeta * zeta)), seconds),
                                 g_strdup(_("period")));
    }
}

/* Where an island is, of each coordinate: its acceleration, its velocity, its place. */
typedef struct {
    double at[3][MOST_WRITTEN];
} Motion;

static double entry_value(const TinkerPage *page, const GPtrArray *entries, guint number)
{
    return tinker_equations_value(page->equations, g_ptr_array_index(entries, number));
}

static double state_value(const TinkerPage *page, TinkerBlockId body, const char *quantity)
{
    g_autofree char *name = g_strconcat(tinker_scene_block_name(page->equations->scene, body), ".", quantity, NULL);
    g_autoptr(TinkerExpression) symbol = tinker_expression_symbol(name);
    return tinker_equations_value(page->equations, symbol);
}

static double velocity(const TinkerPage *page, const TinkerMatrixCoordinate *coordinate)
{
    static const char *const quantities[] = {"vx", "vy"};
    double along = 0;
    if (coordinate->turning) return state_value(page, coordinate->body, "rate");
    for (int axis = 0; axis < 2; axis++)
        if (coordinate->direction[axis] != 0)
            along += coordinate->direction[axis] * state_value(page, coordinate->body, quantities[axis]);
    return along;
}

/* Accelerations by M, which is diagonal. */
static Motion motion_of(const TinkerPage *page, const TinkerMatrixIsland *island)
{
    Motion motion = {{{0}}};
    const GPtrArray *const *matrices = (const GPtrArray *const *)island->matrices;
    const guint n = island->coordinates->len;
    for (guint i = 0; i < n; i++) {
        motion.at[1][i] = velocity(page, coordinate_at(island, i));
        motion.at[2][i] = place_now(page, coordinate_at(island, i));
    }
    for (guint i = 0; i < n; i++) {
        double sum = entry_value(page, island->load, i);
        for (guint k = 0; k < n; k++)
            sum -= entry_value(page, matrices[TINKER_MATRIX_DAMPING], i * n + k) * motion.at[1][k] +
                   entry_value(page, matrices[TINKER_MATRIX_STIFFNESS], i * n + k) * motion.at[2][k];
        motion.at[0][i] = sum / entry_value(page, matrices[TINKER_MATRIX_MASS], i * n + i);
    }
    return motion;
}

static double greatest_value(const GArray *terms)
{
    double most = 0;
    for (guint i = 0; i < terms->len; i++)
        most = fmax(most, fabs(g_array_index(terms, TinkerLineTerm, i).value));
    return most;
}

static void drop_rounding(GArray *terms, double greatest)
{
    for (guint i = 0; i < terms->len; i++) {
        TinkerLineTerm *term = &g_array_index(terms, TinkerLineTerm, i);
        if (fabs(term->value) <= TINKER_FORCE_NOTHING * greatest) term->value = 0;
    }
}

/* Row i for who shows it in parts, each of its block. */
static void line_row(TinkerPage *page, const TinkerMatrixIsland *island, guint i, const Motion *motion)
{
    const guint n = island->coordinates->len;
    const TinkerDimension load = dimensions[coordinate_at(island, i)->turning].load;
    const TinkerEquationLine *line = tinker_page_line_balance(page);
    for (int order = 0; order < 3; order++)
        for (guint k = 0; k < n; k++) {
            const TinkerExpression *entry = g_ptr_array_index(island->matrices[order], i * n + k);
            g_autofree char *variable = coordinate(page, island, k, 2 - order);
            if (!tinker_expression_is_number(entry, 0))
                tinker_page_add_terms(page, line->left_terms, entry, variable, motion->at[order][k], load);
        }
    tinker_page_add_terms(page, line->terms, g_ptr_array_index(island->load, i), NULL, 1, load);
    const double greatest = fmax(greatest_value(line->left_terms), greatest_value(line->terms));
    drop_rounding(line->left_terms, greatest);
    drop_rounding(line->terms, greatest);
}

static void write_rows(TinkerPage *page, const TinkerMatrixIsland *island)
{
    const Motion motion = motion_of(page, island);
    for (guint i = 0; i < island->coordinates->len; i++) {
        if (page->lines != NULL)
            line_row(page, island, i, &motion);
        else
            write_row(page, island, i);
    }
}

static gboolean is_zero(const TinkerMatrixIsland *island, TinkerMatrixKind kind)
{
    if (island->sparse[kind] != NULL) return g_hash_table_size(island->sparse[kind]) == 0;
    for (guint i = 0; i < island->matrices[kind]->len; i++)
        if (!tinker_expression_is_number(g_ptr_array_index(island->matrices[kind], i), 0)) return FALSE;
    return TRUE;
}

/* M q'' + C q' + K q = f, without what is 0. The comment is taken over. */
static void write_whole(TinkerPage *page, const TinkerMatrixIsland *island, char *comment)
{
    GString *sum = g_string_new(NULL);
    for (int kind = 0; kind < TINKER_MATRICES; kind++) {
        if (is_zero(island, kind)) continue;
        g_autofree char *matrix = tinker_page_written(page, page_matrix_letters[kind], "", 0),
                        *vector = tinker_page_written(page, "q", "", 2 - kind);
        if (sum->len > 0) g_string_append(sum, tinker_typeset_sign(page->format, '+'));
        g_string_append_printf(sum, "%s%s%s", matrix, tinker_typeset_sign(page->format, '*'), vector);
    }
    tinker_page_equation(page, g_string_free(sum, FALSE), tinker_page_written(page, "f", "", 0), comment);
}

/* The matrices one below the other, as far as they are not 0. */
static void write_matrices(TinkerPage *page, const TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len;
    const gboolean turning = coordinate_at(island, 0)->turning;
    write_whole(page, island, NULL);
    tinker_page_gap(page);
    for (int kind = 0; kind < TINKER_MATRICES; kind++) {
        const TinkerPageMatrix matrix = {n, n, (const TinkerExpression *const *)(gpointer)island->matrices[kind]->pdata,
                                         dimensions[turning].matrices[kind]};
        if (is_zero(island, kind)) continue;
        tinker_page_matrix(page, tinker_page_written(page, page_matrix_letters[kind], "", 0), &matrix);
        tinker_page_gap(page);
    }
    const TinkerPageMatrix load = {n, 1, (const TinkerExpression *const *)(gpointer)island->load->pdata,
                                   dimensions[turning].load};
    tinker_page_matrix(page, tinker_page_written(page, "f", "", 0), &load);
    tinker_page_gap(page);
}

static void write_patterns(TinkerPage *page, const TinkerMatrixIsland *island)
{
    write_whole(page, island, g_strdup(_("q: the coordinates; f: what else acts on each")));
    for (int kind = 0; kind < TINKER_MATRICES; kind++)
        tinker_page_pattern(page, island, kind);
}

static void write_island(TinkerPage *page, const TinkerMatrixForm *form, const TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len;
    g_autoptr(GString) heading = g_string_new(NULL);
    for (guint i = 0; i < n; i++) {
        const char *name = tinker_scene_block_name(page->equations->scene, coordinate_at(island, i)->body);
        if (i > 0 && coordinate_at(island, i)->body == coordinate_at(island, i - 1)->body) continue;
        if (i < MOST_WRITTEN) g_string_append_printf(heading, "%s%s", heading->len > 0 ? ", " : "", name);
    }
    if (n > MOST_WRITTEN) g_string_append_printf(heading, _(", ...: %u coordinates"), n);
    tinker_page_heading(page, heading->str);
    if (n > MOST_WRITTEN) {
        write_patterns(page, island);
        return;
    }
    if (n > 1) write_matrices(page, island);
    write_rows(page, island);
    tinker_page_gap(page);
    for (guint i = 0; i < n; i++)
        write_coordinate(page, island, i);
    tinker_page_gap(page);
    write_roots(page, form, island);
}

static void mark_all(TinkerPage *page, const GPtrArray *entries, GHashTable *needed)
{
    for (guint i = 0; i < entries->len; i++)
        tinker_equations_mark(page->equations, g_ptr_array_index(entries, i), needed);
}

/* What the symbols of all islands stand for. */
static void write_names(TinkerPage *page, const TinkerMatrixForm *form)
{
    g_autoptr(GHashTable) needed = g_hash_table_new(g_str_hash, g_str_equal);
    for (guint i = 0; i < form->islands->len; i++) {
        const TinkerMatrixIsland *island = g_ptr_array_index(form->islands, i);
        if (island->coordinates->len > MOST_WRITTEN) continue;
        for (guint k = 0; k < island->coordinates->len; k++)
            tinker_equations_mark(page->equations, coordinate_at(island, k)->is, needed);
        for (int kind = 0; kind < TINKER_MATRICES; kind++)
            mark_all(page, island->matrices[kind], needed);
        mark_all(page, island->load, needed);
    }
    tinker_page_names(page, needed);
}

/* Whose pattern is there, whatever it has not. */
static gboolean is_large(const TinkerMatrixForm *form, TinkerBlockId first)
{
    for (guint i = 0; i < form->large->len; i++) {
        const TinkerMatrixIsland *island = g_ptr_array_index(form->large, i);
        if (g_array_index(island->blocks, TinkerBlockId, 0) == first) return TRUE;
    }
    return FALSE;
}

void tinker_equations_put_matrix(TinkerPage *page, const TinkerMatrixForm *form, const TinkerEquationsShown *shown)
{
    for (guint i = 0; i < form->islands->len; i++)
        write_island(page, form, g_ptr_array_index(form->islands, i));
    for (guint i = 0; i < form->large->len; i++)
        write_island(page, form, g_ptr_array_index(form->large, i));
    write_names(page, form);
    for (guint i = 0; i < form->why->len; i++) {
        const TinkerNotWritten *reason = g_ptr_array_index(form->why, i);
        if (is_large(form, reason->block)) continue;
        g_autofree char *heading = g_strdup_printf(
            _("%s has no such equations: %s"),
            reason->block >= 0 ? tinker_scene_block_name(page->equations->scene, reason->block) : _("it"),
            tinker_page_words(reason->why));
        tinker_page_heading(page, heading);
    }
}
