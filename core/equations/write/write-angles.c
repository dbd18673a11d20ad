/* Equations in angles as a page. */
#include "equations/write/page-private.h"

#include "equations/write/write.h"
#include <glib/gi18n-lib.h>

static void write_tree(TinkerPage *page, const TinkerAngleTree *tree)
{
    static const TinkerDimension radians = {0, 0, 0, 1};
    g_autoptr(GString) heading = g_string_new(NULL);
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerRodAngle *angle = &g_array_index(tree->angles, TinkerRodAngle, i);
        g_string_append_printf(heading, "%s%s", i > 0 ? ", " : "",
                               tinker_scene_block_name(page->equations->scene, angle->body));
    }
    tinker_page_heading(page, heading->str);
    for (guint i = 0; i < tree->equations->len; i++)
        tinker_page_vanishes(page, g_ptr_array_index(tree->equations, i));
    tinker_page_gap(page);
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerRodAngle *angle = &g_array_index(tree->angles, TinkerRodAngle, i);
        tinker_page_equation(
            page, tinker_page_symbol(page, angle->angle), tinker_page_quantity(page, angle->value, radians),
            g_strdup_printf(_("%s, from straight down"), tinker_scene_block_name(page->equations->scene, angle->rod)));
    }
}

/* What lengths on bodies are, and how long. */
static void write_lengths(TinkerPage *page, const TinkerAngleForm *form, GHashTable *needed)
{
    if (form->lengths->len > 0) tinker_page_heading(page, C_("equations", "lengths"));
    for (guint i = 0; i < form->lengths->len; i++) {
        const TinkerEquationDefinition *length = g_ptr_array_index(form->lengths, i);
        tinker_equations_mark(page->equations, length->is, needed);
        page->about = length->block;
        tinker_page_equals(page, tinker_page_symbol(page, length->name), length->is,
                           g_strdup_printf("%s: %s", tinker_scene_block_name(page->equations->scene, length->block),
                                           tinker_page_words(length->means)));
        tinker_page_equation(page, tinker_page_symbol(page, length->name),
                             tinker_page_quantity(page, length->value, length->dimension), NULL);
    }
}

void tinker_equations_put_angles(TinkerPage *page, const TinkerAngleForm *form, const TinkerEquationsShown *shown)
{
    const TinkerEquations *equations = page->equations;
    g_autoptr(GHashTable) needed = g_hash_table_new(g_str_hash, g_str_equal);
    for (guint i = 0; i < form->trees->len; i++) {
        const TinkerAngleTree *tree = g_ptr_array_index(form->trees, i);
        write_tree(page, tree);
    }
    tinker_angle_form_mark(form, equations, needed);
    write_lengths(page, form, needed);
    if (form->definitions->len > 0) tinker_page_heading(page, C_("equations", "moved by"));
    for (guint i = 0; i < form->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(form->definitions, i);
        tinker_page_equals(page, tinker_page_symbol(page, definition->name), definition->is,
                           g_strdup(tinker_page_words(definition->means)));
    }
    tinker_page_names(page, needed);
    for (guint i = 0; i < form->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(form->definitions, i);
        tinker_page_state(page, definition->block, tinker_page_symbol(page, definition->name),
                          tinker_page_amount(page, definition->value, definition->dimension, definition->energy), NULL);
    }
    for (guint i = 0; i < form->why->len; i++) {
        const TinkerNotWritten *reason = g_ptr_array_index(form->why, i);
        g_autofree char *heading =
            g_strdup_printf(_("%s has no equations in angles: %s"),
                            tinker_scene_block_name(equations->scene, reason->block), tinker_page_words(reason->why));
        tinker_page_heading(page, heading);
    }
}
