/* The forces on a body as a table, with what they add up to. */
#include <math.h>

#include "cli/report/diagram-report.h"
#include "cli/report/text-table.h"
#include "print.h"

/* `moment`: about the centre of mass, of a body that turns; NAN: there is no column for it. */
static void add_row(TinkerTextTable *table, const char *name, const char *kind, const double force[2], double moment,
                    const char *partner)
{
    tinker_text_table_add(table, name);
    tinker_text_table_add(table, kind);
    tinker_text_table_add_format(table, "%.6g", force[0] + 0.0); /* -0 becomes 0 */
    tinker_text_table_add_format(table, "%.6g", force[1] + 0.0);
    tinker_text_table_add_format(table, "%.6g", hypot(force[0], force[1]));
    if (!isnan(moment)) tinker_text_table_add_format(table, "%.6g", moment);
    tinker_text_table_add(table, partner);
}

void tinker_diagram_write_text(const TinkerDiagram *diagram, TinkerScene *scene, const TinkerBlockId *blocks,
                               FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new(isnan(diagram->inertia) ? "llrrrl" : "llrrrrl", 2);
    g_autoptr(GString) names = g_string_new(NULL);
    for (; *blocks >= 0; blocks++)
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", tinker_scene_block_name(scene, *blocks));
    tinker_print_line(file, "Forces on %s, at t = %g s (N: x, y, magnitude%s)", names->str, diagram->time,
                      isnan(diagram->inertia) ? "" : "; N m: moment about the centre");
    for (guint i = 0; i < diagram->forces->len; i++) {
        const TinkerDiagramForce *force = &g_array_index(diagram->forces, TinkerDiagramForce, i);
        g_autofree char *partner =
            force->partner < 0  ? g_strdup("")
            : force->second < 0 ? g_strdup_printf("opposite on %s", tinker_scene_block_name(scene, force->partner))
                                : g_strdup_printf("on to %s and %s", tinker_scene_block_name(scene, force->partner),
                                                  tinker_scene_block_name(scene, force->second));
        const double moment = (force->point[0] - diagram->centre[0]) * force->force[1] -
                              (force->point[1] - diagram->centre[1]) * force->force[0] + force->torque;
        add_row(table, tinker_scene_block_name(scene, force->from), tinker_term_kind_name(force->kind), force->force,
                isnan(diagram->inertia) ? NAN : moment, partner);
    }
    if (diagram->moves)
        add_row(table, isnan(diagram->inertia) ? "= m a" : "= m a, I α", "", diagram->kinetic,
                isnan(diagram->inertia) ? NAN : diagram->turning, "");
    tinker_text_table_write(table, file);
    for (guint i = 0; i < diagram->cancelled->len; i++)
        tinker_print_line(file, "  %s acts between them: its forces cancel",
                          tinker_scene_block_name(scene, g_array_index(diagram->cancelled, TinkerBlockId, i)));
}
