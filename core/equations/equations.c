/* A scene's equations, block by block. */
#include "equations/equations.h"

#include <string.h>

#include "equations/writer-private.h"

static void symbol_free(void *data)
{
    TinkerEquationSymbol *symbol = data;
    g_free(symbol->name);
    g_free(symbol->property);
    g_free(symbol);
}

static void definition_free(void *data)
{
    TinkerEquationDefinition *definition = data;
    g_free(definition->name);
    g_free(definition->means);
    tinker_expression_unref(definition->is);
    g_free(definition);
}

static void term_clear(void *data)
{
    TinkerTerm *term = data;
    tinker_expression_unref(term->x);
    tinker_expression_unref(term->y);
}

static void body_free(void *data)
{
    TinkerBodyEquation *body = data;
    tinker_expression_unref(body->mass);
    g_array_unref(body->terms);
    g_free(body);
}

static void constraint_free(void *data)
{
    TinkerConstraintEquation *constraint = data;
    tinker_expression_unref(constraint->g);
    g_free(constraint->multiplier);
    g_free(constraint);
}

static void not_written_free(void *data)
{
    TinkerNotWritten *missing = data;
    g_ptr_array_unref(missing->symbols);
    g_free(missing->why);
    g_free(missing);
}

static void line_free(void *data)
{
    TinkerLineEquation *line = data;
    tinker_expression_unref(line->length);
    g_clear_pointer(&line->rate, tinker_expression_unref);
    tinker_expression_unref(line->tension);
    for (int end = 0; end < 2; end++) {
        for (int axis = 0; axis < 2; axis++) {
            tinker_expression_unref(line->place[end][axis]);
            tinker_expression_unref(line->velocity[end][axis]);
        }
    }
    g_free(line);
}

static void look_free(void *data)
{
    TinkerEquationLook *look = data;
    g_free(look->stem);
    g_free(look->index);
    g_free(look);
}

static void add_look(TinkerEquations *equations, const char *name, const char *stem, const char *index, int dots)
{
    TinkerEquationLook *look = g_new(TinkerEquationLook, 1);
    *look = (TinkerEquationLook){g_strdup(stem), g_strdup(index), dots, NULL};
    g_hash_table_insert(equations->looks, g_strdup(name), look);
}

static void add_time(TinkerEquationWriter *writer)
{
    double *time = g_new(double, 1);
    *time = writer->equations->time;
    g_hash_table_insert(writer->equations->values, g_strdup("t"), time);
    add_look(writer->equations, "t", "t", "", 0);
}

/* The symbols of a body's state, and its mass. */
static void add_body(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBodySample *at)
{
    static const char *const quantities[] = {"x", "y", "vx", "vy"}, *const stems[] = {"x", "y"};
    const double values[] = {at->x, at->y, at->vx, at->vy};
    const char *block_name = tinker_scene_block_name(writer->scene, block);
    const char *index = tinker_writer_index(writer, block);
    TinkerEquations *equations = writer->equations;
    for (int i = 0; i < 4; i++) {
        g_autofree char *name = g_strconcat(block_name, ".", quantities[i], NULL);
        const TinkerDimension dimension = i < 2 ? tinker_length_dimension : tinker_velocity_dimension;
        add_look(equations, name, stems[i % 2], index, i / 2);
        tinker_expression_unref(tinker_writer_symbol(writer, name, block, values[i], dimension, NULL, quantities[i]));
    }
    TinkerBodyEquation *body = g_new(TinkerBodyEquation, 1);
    *body = (TinkerBodyEquation){block, tinker_writer_meaning(writer, block, TINKER_MEANING_MASS, 0, "m"),
                                 g_array_new(FALSE, FALSE, sizeof(TinkerTerm))};
    g_array_set_clear_func(body->terms, term_clear);
    g_ptr_array_add(equations->bodies, body);
    g_hash_table_insert(writer->body_of, GINT_TO_POINTER(block), body);
    /* what acts away from its centre is written as if it acted there: better told than left out */
    if (tinker_scene_block_class(writer->scene, block)->physics->body->degrees_of_freedom <= 2) return;
    TinkerNotWritten *missing = g_new(TinkerNotWritten, 1);
    *missing = (TinkerNotWritten){block, g_ptr_array_new_with_free_func(g_free),
                                  g_strdup("it turns: its rotation, and the places of its ends, are not written yet")};
    g_ptr_array_add(equations->not_written, missing);
}

typedef gboolean (*AddRole)(TinkerEquationWriter *writer, TinkerBlockId block, const TinkerBlockLaw *law);

static void add_block(TinkerEquationWriter *writer, TinkerBlockId block)
{
    static const struct {
        AddRole add;
        TinkerTermKind kind;
    } roles[] = {
        [TINKER_LAW_LINE] = {tinker_writer_add_line, TINKER_TERM_CONNECTOR},
        [TINKER_LAW_FORCE] = {tinker_writer_add_force, TINKER_TERM_FORCE},
        [TINKER_LAW_FIELD] = {tinker_writer_add_field, TINKER_TERM_FIELD},
        [TINKER_LAW_CONSTRAINT] = {tinker_writer_add_constraint, TINKER_TERM_CONSTRAINT},
    };
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
    const TinkerLawRole role = tinker_law_role(block_class);
    if (role >= TINKER_LAW_MOTION) return;
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerBlockLaw) law =
        tinker_block_law_new(block_class, tinker_scene_end_count(writer->scene, block), &error);
    if (law != NULL && roles[role].add(writer, block, law)) return;
    g_autofree char *why = error != NULL ? g_strdup_printf("its law cannot be read: %s", error->message)
                           : law != NULL ? g_strdup("its law does not say what it does to its ends")
                                         : g_strdup("its plugin states no law");
    tinker_writer_add_unwritten(writer, block, roles[role].kind, why);
}

static gboolean turns(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class != NULL ? block_class->physics : NULL;
    return physics != NULL && physics->body != NULL && physics->body->degrees_of_freedom == 3;
}

static void write_all(TinkerEquationWriter *writer)
{
    const TinkerModelState *state = writer->state;
    tinker_writer_number_blocks(writer);
    add_time(writer);
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodyState *body = &g_array_index(state->bodies, TinkerBodyState, i);
        add_body(writer, body->block, &body->at);
    }
    for (int32_t i = 0; i < tinker_scene_block_count(writer->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(writer->scene, i);
        add_block(writer, block);
        if (turns(tinker_scene_block_class(writer->scene, block)))
            tinker_writer_note_unwritten(writer, block, "its angle", "how it turns is not written yet");
    }
    tinker_writer_add_contacts(writer);
}

TinkerEquations *tinker_equations_new(TinkerScene *scene, const TinkerModelState *state, GError **error)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    if (frame == NULL) return NULL;
    TinkerEquations *equations = g_new0(TinkerEquations, 1);
    *equations = (TinkerEquations){
        .scene = scene,
        .time = state->time,
        .bodies = g_ptr_array_new_with_free_func(body_free),
        .symbols = g_ptr_array_new_with_free_func(symbol_free),
        .definitions = g_ptr_array_new_with_free_func(definition_free),
        .constraints = g_ptr_array_new_with_free_func(constraint_free),
        .not_written = g_ptr_array_new_with_free_func(not_written_free),
        .lines = g_ptr_array_new_with_free_func(line_free),
        .rods = g_ptr_array_new_with_free_func(line_free),
        .looks = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, look_free),
        .values = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
    };
    TinkerEquationWriter writer = {
        .equations = equations,
        .scene = scene,
        .state = state,
        .frame = frame,
        .indices = g_hash_table_new_full(NULL, NULL, NULL, g_free),
        .stems = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
        .by_name = g_hash_table_new(g_str_hash, g_str_equal),
        .points = tinker_writer_points_new(),
        .body_of = g_hash_table_new(NULL, NULL),
    };
    write_all(&writer);
    GHashTable *const tables[] = {writer.indices, writer.stems, writer.by_name, writer.points, writer.body_of};
    for (gsize i = 0; i < G_N_ELEMENTS(tables); i++)
        g_hash_table_unref(tables[i]);
    return equations;
}

void tinker_equations_free(TinkerEquations *equations)
{
    GPtrArray *const lists[] = {equations->bodies,      equations->symbols,     equations->definitions,
                                equations->constraints, equations->not_written, equations->lines,
                                equations->rods};
    for (gsize i = 0; i < G_N_ELEMENTS(lists); i++)
        g_ptr_array_unref(lists[i]);
    g_hash_table_unref(equations->looks);
    g_hash_table_unref(equations->values);
    g_free(equations);
}
