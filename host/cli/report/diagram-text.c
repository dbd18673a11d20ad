/* The forces on a body as a table, with what they add up to. */
#include <math.h>

#include "cli/report/diagram-report.h"
#include "cli/report/text-table.h"
#include "common/program/print.h"

#define NOTHING 1e-12 /* of the greatest force, or of all moments together: what rounding leaves */

typedef struct {
    TinkerTextTable *table;
    gboolean turns;             /* there is a column for moments about the centre of mass */
    double no_force, no_moment; /* N, N m: what is less than that is 0 */
} Table;

static void add_head(const Table *to)
{
    static const char *const heads[] = {"force", "", "x [N]", "y [N]", "size [N]"};
    for (gsize i = 0; i < G_N_ELEMENTS(heads); i++)
        tinker_text_table_add(to->table, heads[i]);
    if (to->turns) tinker_text_table_add(to->table, "moment [N m]");
    tinker_text_table_add(to->table, "");
}

static void add_number(const Table *to, double value, double nothing)
{
    tinker_text_table_add_format(to->table, "%.6g", fabs(value) > nothing ? value : 0);
}

static void add_row(const Table *to, const char *name, const char *kind, const double force[2], double moment,
                    const char *partner)
{
    tinker_text_table_add(to->table, name);
    tinker_text_table_add(to->table, kind);
    add_number(to, force[0], to->no_force);
    add_number(to, force[1], to->no_force);
    add_number(to, hypot(force[0], force[1]), to->no_force);
    if (to->turns) add_number(to, moment, to->no_moment);
    tinker_text_table_add(to->table, partner);
}

static double moment_of(const TinkerDiagram *diagram, const TinkerDiagramForce *force)
{
    return (force->point[0] - diagram->centre[0]) * force->force[1] -
           (force->point[1] - diagram->centre[1]) * force->force[0] + force->torque;
}

/* Of what acts at several ends of a rope with the number of the end. (transfer full) */
static char *name_of(TinkerScene *scene, const TinkerDiagramForce *force)
{
    const char *from = tinker_scene_block_name(scene, force->from);
    return force->end > 0 ? g_strdup_printf("%s, end %d", from, force->end) : g_strdup(from);
}

/* What the other end has: (transfer full) */
static char *partner_of(TinkerScene *scene, const TinkerDiagramForce *force)
{
    if (force->partner < 0) return g_strdup("");
    const char *partner = tinker_scene_block_name(scene, force->partner);
    return force->second < 0
               ? g_strdup_printf("opposite on %s", partner)
               : g_strdup_printf("on to %s and %s", partner, tinker_scene_block_name(scene, force->second));
}

static void find_nothing(Table *to, const TinkerDiagram *diagram)
{
    for (guint i = 0; i < diagram->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(diagram->forces, TinkerDiagramForce, i);
        const double size = hypot(force->force[0], force->force[1]);
        const double arm = hypot(force->point[0] - diagram->centre[0], force->point[1] - diagram->centre[1]);
        to->no_force = fmax(to->no_force, NOTHING * size);
        to->no_moment += NOTHING * (size * arm + fabs(force->torque));
    }
}

void tinker_diagram_write_text(const TinkerDiagram *diagram, TinkerScene *scene, const TinkerBlockId *blocks,
                               FILE *file)
{
    const gboolean turns = !isnan(diagram->inertia);
    g_autoptr(TinkerTextTable) table = tinker_text_table_new(turns ? "llrrrrl" : "llrrrl", 2);
    g_autoptr(GString) names = g_string_new(NULL);
    Table to = {table, turns, 0, 0};
    for (; *blocks >= 0; blocks++)
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", tinker_scene_block_name(scene, *blocks));
    tinker_print_line(file, "Forces on %s, at t = %g s%s", names->str, diagram->time,
                      turns ? " (moments about the centre of mass)" : "");
    find_nothing(&to, diagram);
    if (diagram->forces->len > 0 || diagram->moves) add_head(&to);
    for (guint i = 0; i < diagram->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(diagram->forces, TinkerDiagramForce, i);
        g_autofree char *partner = partner_of(scene, force), *name = name_of(scene, force);
        add_row(&to, name, tinker_term_kind_name(force->kind), force->force, moment_of(diagram, force), partner);
    }
    if (diagram->moves) add_row(&to, turns ? "= m a, I α" : "= m a", "", diagram->kinetic, diagram->turning, "");
    tinker_text_table_write(table, file);
    if (diagram->forces->len == 0 && !diagram->moves) tinker_print_line(file, "  nothing acts on it");
    for (guint i = 0; i < diagram->cancelled->len; i++)
        tinker_print_line(file, "  %s acts between them: its forces cancel",
                          tinker_scene_block_name(scene, g_array_index(diagram->cancelled, TinkerBlockId, i)));
}
