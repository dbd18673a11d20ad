/* Block types and integrators for people, as tables. Values are in SI, as in a scene; the unit they are displayed in
 * stands beside. */
#include "cli/plugins/plugins-show.h"

#include <string.h>

#include "cli/report/text-table.h"
#include "common/program/print.h"
#include "law/law-text.h"
#include "scene/frame/tops.h"
#include "scene/store/quantities.h"
#include "units/quantity/units.h"

static const char *kind_name(int32_t kind)
{
    static const char *const names[] = {
        [TINKER_KIND_REAL] = "number",       [TINKER_KIND_INTEGER] = "whole number",
        [TINKER_KIND_SWITCH] = "switch",     [TINKER_KIND_CHOICE] = "choice",
        [TINKER_KIND_TEXT] = "text",         [TINKER_KIND_VECTOR] = "vector",
        [TINKER_KIND_WAVEFORM] = "waveform",
    };
    return kind >= 0 && kind < (int32_t)G_N_ELEMENTS(names) ? names[kind] : "?";
}

static const char *number_text(double value, char text[32])
{
    tinker_number_to_text(value, text, 32);
    return text;
}

/* What a property is when a scene leaves it out. (transfer full) */
static char *default_text(const TinkerPropertyType *property)
{
    char first[32], second[32];
    if (property->flags & TINKER_READ_ONLY) return g_strdup("read-only");
    if (property->flags & TINKER_DEFAULT_AS_PLACED) return g_strdup("as placed");
    if (property->flags & TINKER_DEFAULT_AS_SHAPED) return g_strdup("as shaped");
    if (property->flags & TINKER_DEFAULT_NONE) return g_strdup("none");
    if (property->flags & TINKER_DEFAULT_SAME_AS) return g_strdup_printf("= %s", property->default_from);
    switch (property->kind) {
    case TINKER_KIND_SWITCH:
        return g_strdup(property->default_value[0] != 0 ? "true" : "false");
    case TINKER_KIND_CHOICE:
        return g_strdup(property->choices[(int32_t)property->default_value[0]]);
    case TINKER_KIND_TEXT:
    case TINKER_KIND_WAVEFORM:
        return g_strdup(property->default_text != NULL ? property->default_text : "");
    case TINKER_KIND_VECTOR:
        return g_strdup_printf("[%s, %s]", number_text(property->default_value[0], first),
                               number_text(property->default_value[1], second));
    default:
        return g_strdup(number_text(property->default_value[0], first));
    }
}

/* (transfer full) */
static char *range_text(const TinkerPropertyType *property)
{
    char number[32];
    gboolean has_minimum = (property->flags & TINKER_HAS_MINIMUM) != 0,
             has_maximum = (property->flags & TINKER_HAS_MAXIMUM) != 0;
    g_autoptr(GString) range = g_string_new(NULL);
    if (has_minimum)
        g_string_append_printf(range, "%s %s", property->flags & TINKER_OPEN_MINIMUM ? ">" : ">=",
                               number_text(property->hard_minimum, number));
    if (has_maximum)
        g_string_append_printf(
            range, "%s%s %s", has_minimum ? ", " : "",
            property->flags & TINKER_OPEN_MAXIMUM ? "<" : "<=", number_text(property->hard_maximum, number));
    for (int32_t i = 0; property->kind == TINKER_KIND_CHOICE && i < property->choice_count; i++)
        g_string_append_printf(range, "%s%s", i > 0 ? ", " : "", property->choices[i]);
    return g_strdup(range->str);
}

/* "kg (slug)": the unit of SI display and of English display; one where they agree. (transfer full) */
static char *display_units(const TinkerBlockClass *block_class, const char *id, TinkerDimension dimension)
{
    const char *si = tinker_block_class_unit(block_class, id, dimension, 0);
    const char *english = tinker_block_class_unit(block_class, id, dimension, 1);
    return strcmp(si, english) == 0 ? g_strdup(si) : g_strdup_printf("%s, %s", si, english);
}

static void show_properties(const TinkerBlockClass *block_class, FILE *file)
{
    if (block_class->property_count == 0) return;
    static const char *const headings[] = {"PROPERTY", "LABEL",    "GROUP",   "KIND",
                                           "SI UNIT",  "SHOWN IN", "DEFAULT", "RANGE"};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("llllllll", 2);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        g_autofree char *units = display_units(block_class, property->id, property->dimension);
        g_autofree char *value = default_text(property);
        g_autofree char *range = range_text(property);
        tinker_text_table_add(table, property->id);
        tinker_text_table_add(table, property->title);
        tinker_text_table_add(table, property->group);
        tinker_text_table_add(table,
                              (property->flags & TINKER_TEXT_POINTS) != 0 ? "points" : kind_name(property->kind));
        tinker_text_table_add(table, tinker_block_class_si_unit(block_class, property->id, property->dimension));
        tinker_text_table_add(table, units);
        tinker_text_table_add(table, value);
        tinker_text_table_add(table, range);
    }
    fputs("\nProperties, as in a scene; values in SI:\n", file);
    tinker_text_table_write(table, file);
    if (tinker_class_can_be_put(block_class))
        fputs(
            "In place of a position: \"on\": NAME lies on the top of that support, and \"along\": NUMBER says how far "
            "from its middle,\nin m towards the support's +x (0).\n",
            file);
}

static void show_quantities(const TinkerBlockClass *block_class, FILE *file)
{
    g_autoptr(GArray) types = tinker_class_quantities(block_class);
    if (types->len == 0) return;
    static const char *const headings[] = {"QUANTITY", "CURVE", "SI UNIT", "SHOWN IN", "RECORDED", "MEANING"};
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("llllll", 2);
    for (gsize i = 0; i < G_N_ELEMENTS(headings); i++)
        tinker_text_table_add(table, headings[i]);
    for (guint i = 0; i < types->len; i++) {
        const TinkerQuantityType *quantity = &g_array_index(types, TinkerQuantityType, i);
        g_autofree char *units = display_units(block_class, quantity->id, quantity->dimension);
        tinker_text_table_add(table, quantity->id);
        tinker_text_table_add(table, quantity->title);
        tinker_text_table_add(table, tinker_block_class_si_unit(block_class, quantity->id, quantity->dimension));
        tinker_text_table_add(table, units);
        tinker_text_table_add(table, quantity->flags & TINKER_RECORDED ? "always" : "if asked");
        tinker_text_table_add(table, quantity->description);
    }
    fputs("\nQuantities, for graphs and --columns, as in --columns \"NAME.QUANTITY,NAME.QUANTITY\":\n", file);
    tinker_text_table_write(table, file);
}

/* (transfer full) */
static char *ends_text(const TinkerBlockType *type)
{
    if (type->most_ends == 0) return g_strdup("none");
    gboolean body = (type->end_accepts & TINKER_ACCEPTS_BODY) != 0,
             support = (type->end_accepts & TINKER_ACCEPTS_SUPPORT) != 0;
    const char *where = body && support ? "bodies and supports" : body ? "bodies" : "supports";
    if (type->most_ends < 0) return g_strdup_printf("%d or more, on %s", type->least_ends, where);
    if (type->most_ends == type->least_ends) return g_strdup_printf("%d, on %s", type->most_ends, where);
    return g_strdup_printf("%d to %d, on %s", type->least_ends, type->most_ends, where);
}

/* "physics (line law), render, graph". (transfer full) */
static char *interfaces_text(const TinkerBlockClass *block_class)
{
    g_autoptr(GPtrArray) names = g_ptr_array_new();
    const TinkerPhysics *physics = block_class->physics;
    if (physics != NULL) {
        const struct {
            const void *offered;
            const char *name;
        } roles[] = {
            {physics->body, "physics (body)"},
            {physics->line_law, "physics (line law)"},
            {physics->force_element, "physics (force element)"},
            {physics->field, "physics (field)"},
            {physics->constraint, "physics (constraint)"},
            {physics->motion, "physics (motion)"},
        };
        for (gsize i = 0; i < G_N_ELEMENTS(roles); i++)
            if (roles[i].offered != NULL) g_ptr_array_add(names, (gpointer)roles[i].name);
    }
    if (block_class->render != NULL) g_ptr_array_add(names, (gpointer) "render");
    if (block_class->edit != NULL) g_ptr_array_add(names, (gpointer) "edit");
    if (block_class->units != NULL) g_ptr_array_add(names, (gpointer) "units");
    if (block_class->graph != NULL) g_ptr_array_add(names, (gpointer) "graph");
    g_ptr_array_add(names, NULL);
    return g_strjoinv(", ", (char **)names->pdata);
}

/* What an integrator's flags say. (transfer full) */
static char *integrator_kind(const TinkerIntegrator *integrator)
{
    const gboolean adaptive = (integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    const struct {
        guint32 flag;
        const char *name;
    } names[] = {
        {TINKER_INTEGRATOR_EXPLICIT, "explicit"},
        {TINKER_INTEGRATOR_IMPLICIT, "implicit"},
        {TINKER_INTEGRATOR_SYMPLECTIC, "symplectic where undamped"},
        {TINKER_INTEGRATOR_LINEAR, "for linear systems alone"},
    };
    g_autoptr(GString) kind = g_string_new(adaptive ? "adaptive (takes a tolerance)" : "fixed steps");
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++)
        if (integrator->flags & names[i].flag) g_string_append_printf(kind, ", %s", names[i].name);
    return g_strdup(kind->str);
}

/* "step * omega up to 2.828". (transfer full) */
static char *limit_text(const char *what, double limit)
{
    if (limit < 0) return g_strdup("any step is stable");
    if (limit == 0) return g_strdup("no step is stable");
    return g_strdup_printf("%s up to %.4g", what, limit);
}

/* A row each, and one more for each further line of its text. */
static void show_rows(const char *const (*rows)[2], gsize count, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("ll", 2);
    for (gsize i = 0; i < count; i++) {
        if (rows[i][1] == NULL) continue;
        g_auto(GStrv) lines = g_strsplit(rows[i][1], "\n", -1);
        for (gsize k = 0; lines[k] != NULL; k++) {
            tinker_text_table_add(table, k == 0 ? rows[i][0] : "");
            tinker_text_table_add(table, lines[k]);
        }
    }
    fputc('\n', file);
    tinker_text_table_write(table, file);
}

void tinker_plugins_show(const TinkerBlockClass *block_class, FILE *file)
{
    const TinkerBlockType *type = block_class->type;
    const TinkerPlugin *plugin = block_class->plugin;
    g_auto(GStrv) lines = tinker_class_law_lines(block_class);
    g_autofree char *law = lines[0] != NULL ? g_strjoinv("\n", lines) : NULL;
    g_autofree char *ends = ends_text(type);
    g_autofree char *interfaces = interfaces_text(block_class);
    g_autofree char *version = g_strdup_printf("%s %s, %s", plugin->id, plugin->version, plugin->licence);
    tinker_print_line(file, "%s: %s (%s)", type->id, type->title, type->category);
    if (type->summary != NULL) tinker_print_line(file, "%s", type->summary);
    const char *const rows[][2] = {
        {"law", law},
        {"ends", ends},
        {"interfaces", interfaces},
        {"plugin", version},
        {"library", block_class->path},
        {"help", type->help_link},
    };
    show_rows(rows, G_N_ELEMENTS(rows), file);
    show_properties(block_class, file);
    show_quantities(block_class, file);
}

void tinker_plugins_show_integrator(const TinkerIntegrator *integrator, const TinkerLibraryEntry *library, FILE *file)
{
    g_autofree char *kind = integrator_kind(integrator);
    g_autofree char *order = g_strdup_printf("%d; between steps %d", integrator->order, integrator->dense_order);
    g_autofree char *undamped = limit_text("step * omega", integrator->imaginary_limit);
    g_autofree char *damped = limit_text("step * c / m", integrator->real_limit);
    g_autofree char *evaluations = g_strdup_printf("%d a step", integrator->evaluations_per_step);
    g_autofree char *plugin =
        library == NULL ? NULL : g_strdup_printf("%s %s, %s", library->id, library->version, library->licence);
    tinker_print_line(file, "%s: %s (integrator)", integrator->id, integrator->title);
    if (integrator->summary != NULL) tinker_print_line(file, "%s", integrator->summary);
    const char *const rows[][2] = {
        {"kind", kind},
        {"order", order},
        {"evaluations", evaluations},
        {"undamped", undamped},
        {"damper alone", damped},
        {"source", integrator->source},
        {"plugin", plugin},
        {"library", library == NULL ? "built in" : library->path},
    };
    show_rows(rows, G_N_ELEMENTS(rows), file);
}
