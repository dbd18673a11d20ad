/* Names of symbols: the stem that the block's author gave, "k", with a number where several blocks have it. */
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"

/* Blocks are numbered among those of their group. */
typedef enum { GROUP_BODIES, GROUP_SUPPORTS, GROUP_CONNECTORS, GROUP_OTHERS, GROUP_COUNT } Group;

static Group group_of(const TinkerBlockClass *block_class)
{
    const TinkerBody *body = block_class->physics != NULL ? block_class->physics->body : NULL;
    const TinkerLawRole role = tinker_law_role(block_class);
    if (role == TINKER_LAW_LINE || role == TINKER_LAW_CONSTRAINT) return GROUP_CONNECTORS;
    if (body == NULL) return GROUP_OTHERS;
    return body->degrees_of_freedom > 0 ? GROUP_BODIES : GROUP_SUPPORTS;
}

/* The digits at the end of a name; "" for none. */
static const char *digits_of(const char *name)
{
    const char *at = name + strlen(name);
    while (at > name && g_ascii_isdigit(at[-1]))
        at--;
    return at;
}

/* By the digits of their names, where all have some and no two the same; else from 1 on. */
static void number_group(TinkerEquationWriter *writer, const GArray *blocks)
{
    g_autoptr(GHashTable) seen = g_hash_table_new(g_str_hash, g_str_equal);
    gboolean by_digits = TRUE;
    for (guint i = 0; i < blocks->len; i++) {
        const char *name = tinker_scene_block_name(writer->scene, g_array_index(blocks, TinkerBlockId, i));
        const char *digits = digits_of(name);
        by_digits = by_digits && digits[0] != '\0' && strlen(digits) < 5 && g_hash_table_add(seen, (void *)digits);
    }
    for (guint i = 0; i < blocks->len; i++) {
        const TinkerBlockId block = g_array_index(blocks, TinkerBlockId, i);
        const char *name = tinker_scene_block_name(writer->scene, block);
        char *index = blocks->len == 1 ? g_strdup("")
                      : by_digits      ? g_strdup(digits_of(name))
                                       : g_strdup_printf("%u", i + 1);
        g_hash_table_insert(writer->indices, GINT_TO_POINTER(block), index);
    }
}

TinkerBlockLaw *tinker_writer_law_of(const TinkerEquationWriter *writer, TinkerBlockId block, GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
    const int32_t ends = tinker_scene_end_count(writer->scene, block);
    if (block_class->law_count > 0 || tinker_law_role(block_class) == TINKER_LAW_NONE)
        return tinker_block_law_new(block_class, ends, error);
    TinkerSceneTexts texts = {writer->scene, block};
    return tinker_block_law_new_typed(block_class, ends, tinker_scene_text_of, &texts, error);
}

static void count_stem(TinkerEquationWriter *writer, const char *stem)
{
    const int before = GPOINTER_TO_INT(g_hash_table_lookup(writer->stems, stem));
    g_hash_table_insert(writer->stems, g_strdup(stem), GINT_TO_POINTER(before + 1));
}

/* Of a body with a surface of its own. */
static void count_surface(TinkerEquationWriter *writer, TinkerBlockId block)
{
    static const struct {
        int32_t meaning;
        const char *stem;
    } coefficients[] = {{TINKER_MEANING_STATIC_FRICTION, "μs"}, {TINKER_MEANING_DYNAMIC_FRICTION, "μd"}};
    for (gsize i = 0; i < G_N_ELEMENTS(coefficients); i++)
        if (!isnan(tinker_frame_meaning(writer->frame, block, coefficients[i].meaning, 0, NAN)))
            count_stem(writer, coefficients[i].stem);
}

static void count_stems(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockClass *block_class,
                        Group group)
{
    static const char *const of_bodies[] = {"m", "I", "x", "y", "θ", "h", "R", NULL};
    static const char *const of_supports[] = {"X",  "Y",  "φ",  "X0", "Y0", "φ0", "H", "N", "f",
                                              "μs", "μd", "s0", "σ",  "r",  "a",  "M", NULL};
    /* of what acts without a law, and of what moves so */
    static const char *const of_unwritten[] = {"F", "τ", NULL}, *const of_motions[] = {"u", NULL};
    static const char *const of_lines[] = {"L", "T", NULL}, *const of_constraints[] = {"L", "λ", NULL};
    static const char *const of_others[] = {"V", "F", NULL};
    const TinkerLawRole role = tinker_law_role(block_class);
    const char *const *stems = group == GROUP_BODIES           ? of_bodies
                               : group == GROUP_SUPPORTS       ? of_supports
                               : role == TINKER_LAW_LINE       ? of_lines
                               : role == TINKER_LAW_CONSTRAINT ? of_constraints
                                                               : of_others;
    for (; *stems != NULL; stems++)
        count_stem(writer, *stems);
    if (group == GROUP_BODIES) count_surface(writer, block);
    g_autoptr(TinkerBlockLaw) law = tinker_writer_law_of(writer, block, NULL);
    const gboolean moves = block_class->physics != NULL && block_class->physics->motion != NULL;
    for (stems = moves ? of_motions : of_unwritten; law == NULL && group != GROUP_BODIES && *stems != NULL; stems++)
        count_stem(writer, *stems);
    for (guint i = 0; law != NULL && i < law->symbols->len; i++) {
        const TinkerLawSymbol *symbol = &g_array_index(law->symbols, TinkerLawSymbol, i);
        if (symbol->property >= 0) count_stem(writer, symbol->name);
    }
    for (guint i = 0; law != NULL && i < law->definitions->len; i++) {
        const char *symbol = g_array_index(law->definitions, TinkerLawDefinition, i).symbol;
        if (tinker_law_is_step(symbol)) count_stem(writer, symbol);
    }
}

void tinker_writer_number_blocks(TinkerEquationWriter *writer)
{
    GArray *groups[GROUP_COUNT];
    for (int i = 0; i < GROUP_COUNT; i++)
        groups[i] = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t i = 0; i < tinker_scene_block_count(writer->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(writer->scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
        if (block_class == NULL) continue;
        const Group group = group_of(block_class);
        writer->constrained |= tinker_law_role(block_class) == TINKER_LAW_CONSTRAINT;
        g_array_append_val(groups[group], block);
        count_stems(writer, block, block_class, group);
    }
    for (int i = 0; i < GROUP_COUNT; i++) {
        number_group(writer, groups[i]);
        g_array_unref(groups[i]);
    }
}

const char *tinker_writer_index(const TinkerEquationWriter *writer, TinkerBlockId block)
{
    const char *index = g_hash_table_lookup(writer->indices, GINT_TO_POINTER(block));
    return index != NULL ? index : "";
}

char *tinker_equations_name(const char *stem, const char *index, int dots, const char *component)
{
    static const char *const derivatives[] = {"", "_d", "_dd"};
    return g_strconcat(stem, component != NULL ? component : "", derivatives[dots], index[0] != '\0' ? "_" : "", index,
                       NULL);
}

void tinker_equations_add_look(TinkerEquations *equations, const char *name, const char *stem, const char *index,
                               int dots, const char *component)
{
    TinkerEquationLook *look = g_new(TinkerEquationLook, 1);
    *look = (TinkerEquationLook){g_strdup(stem), g_strdup(index), dots, g_intern_string(component)};
    g_hash_table_insert(equations->looks, g_strdup(name), look);
    g_hash_table_add(equations->taken, tinker_equations_name(stem, index, dots, component));
}

void tinker_equations_reserve(TinkerEquations *equations, const char *stem, const char *index)
{
    g_hash_table_add(equations->taken, tinker_equations_name(stem, index, 0, NULL));
}

char *tinker_equations_free_index(const TinkerEquations *equations, TinkerBlockId block, const char *stem,
                                  const char *index, int dots, const char *component)
{
    char *shown = g_strdup(index);
    for (int again = 0;; again++) {
        g_autofree char *name = tinker_equations_name(stem, shown, dots, component);
        if (!g_hash_table_contains(equations->taken, name)) return shown;
        /* taken by a block of another group: by the block's own name, which is unique, and that in turn by a number */
        const char *own = block >= 0 ? tinker_scene_block_name(equations->scene, block) : "";
        g_free(shown);
        shown = again == 0 ? g_strdup(own) : g_strdup_printf("%s %d", own, again);
    }
}

const char *tinker_equations_free_name(TinkerEquations *equations, TinkerBlockId block, const char *stem,
                                       const char *index, int dots, const char *component)
{
    g_autofree char *shown = tinker_equations_free_index(equations, block, stem, index, dots, component);
    g_autofree char *name = tinker_equations_name(stem, shown, dots, component);
    gpointer kept = NULL;
    tinker_equations_add_look(equations, name, stem, shown, dots, component);
    g_hash_table_lookup_extended(equations->looks, name, &kept, NULL);
    return kept;
}

const char *tinker_writer_name(TinkerEquationWriter *writer, TinkerBlockId block, const char *stem, int dots,
                               const char *component)
{
    const gboolean only = GPOINTER_TO_INT(g_hash_table_lookup(writer->stems, stem)) <= 1;
    return tinker_equations_free_name(writer->equations, block, stem, only ? "" : tinker_writer_index(writer, block),
                                      dots, component);
}
