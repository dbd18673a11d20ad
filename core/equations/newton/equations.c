/* A scene's equations, block by block. */
#include "equations/newton/equations.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"

static void symbol_free(void *data)
{
    TinkerEquationSymbol *symbol = data;
    g_free(symbol->name);
    g_free(symbol->property);
    g_free(symbol);
}

void tinker_equation_definition_free(void *data)
{
    TinkerEquationDefinition *definition = data;
    g_free(definition->name);
    g_free(definition->means);
    tinker_expression_unref(definition->is);
    g_free(definition);
}

static void body_free(void *data)
{
    TinkerBodyEquation *body = data;
    tinker_expression_unref(body->mass);
    g_clear_pointer(&body->inertia, tinker_expression_unref);
    g_array_unref(body->terms);
    g_free(body);
}

static void constraint_free(void *data)
{
    TinkerConstraintEquation *constraint = data;
    tinker_expression_unref(constraint->g);
    g_free(constraint->multiplier);
    if (constraint->limit != NULL) tinker_expression_unref(constraint->limit);
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
            tinker_expression_unref(line->local[end][axis]);
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

static void add_time(TinkerEquationWriter *writer)
{
    double *time = g_new(double, 1);
    *time = writer->time_behind;
    g_hash_table_insert(writer->equations->values, g_strdup("t"), time);
    tinker_equations_add_look(writer->equations, "t", "t", "", 0, NULL);
}

/* The symbols of a body's state, its mass, and its inertia if it turns. */
static void add_body(TinkerEquationWriter *writer, const TinkerBodyState *state)
{
    const double speed = hypot(state->at.vx, state->at.vy);
    const struct {
        const char *quantity, *stem;
        int dots;
        double value, scale; /* what its rounding is that of */
        TinkerDimension dimension;
    } quantities[] = {
        {"x", "x", 0, state->at.x, writer->extent, tinker_length_dimension},
        {"y", "y", 0, state->at.y, writer->extent, tinker_length_dimension},
        {"vx", "x", 1, state->at.vx, speed, tinker_velocity_dimension},
        {"vy", "y", 1, state->at.vy, speed, tinker_velocity_dimension},
        {"angle", "θ", 0, state->angle, fmax(1, fabs(state->angle)), tinker_angle_dimension},
        {"rate", "θ", 1, state->rate, fabs(state->rate), {0, 0, -1, 1}},
    };
    const TinkerBlockId block = state->block;
    const char *block_name = tinker_scene_block_name(writer->scene, block);
    const char *index = tinker_writer_index(writer, block);
    TinkerEquations *equations = writer->equations;
    for (gsize i = 0; i < (state->turns ? 6 : 4); i++) {
        g_autofree char *name = g_strconcat(block_name, ".", quantities[i].quantity, NULL);
        tinker_equations_add_look(equations, name, quantities[i].stem, index, quantities[i].dots, NULL);
        tinker_expression_unref(tinker_writer_symbol(writer, name, block, quantities[i].value, quantities[i].dimension,
                                                     NULL, quantities[i].quantity));
        tinker_equations_set_rounding(equations, name, DBL_EPSILON * quantities[i].scale);
    }
    if (writer->constrained) tinker_equations_reserve(equations, "θ", index);
    TinkerBodyEquation *body = g_new(TinkerBodyEquation, 1);
    *body = (TinkerBodyEquation){block, tinker_writer_meaning(writer, block, TINKER_MEANING_MASS, 0, "m"), NULL,
                                 g_array_new(FALSE, FALSE, sizeof(TinkerTerm))};
    if (state->turns) body->inertia = tinker_writer_meaning(writer, block, TINKER_MEANING_INERTIA, 0, "I");
    g_array_set_clear_func(body->terms, tinker_term_clear);
    g_ptr_array_add(equations->bodies, body);
    g_hash_table_insert(writer->body_of, GINT_TO_POINTER(block), body);
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
    g_autoptr(TinkerBlockLaw) law = tinker_writer_law_of(writer, block, &error);
    if (law != NULL && roles[role].add(writer, block, law)) return;
    g_autofree char *why = error != NULL ? g_strdup_printf("its law cannot be read: %s", error->message)
                           : law != NULL ? g_strdup("its law does not say what it does to its ends")
                                         : g_strdup("its plugin states no law");
    tinker_writer_add_unwritten(writer, block, roles[role].kind, why);
}

/* m: how far from the origin bodies are. */
static double extent_of(const TinkerModelState *state)
{
    double extent = 0;
    for (guint i = 0; i < state->bodies->len; i++) {
        const TinkerBodySample *at = &g_array_index(state->bodies, TinkerBodyState, i).at;
        extent = fmax(extent, hypot(at->x, at->y));
    }
    return extent;
}

static void write_all(TinkerEquationWriter *writer)
{
    const TinkerModelState *state = writer->state;
    writer->extent = extent_of(state);
    tinker_writer_number_blocks(writer);
    add_time(writer);
    for (guint i = 0; i < state->bodies->len; i++)
        add_body(writer, &g_array_index(state->bodies, TinkerBodyState, i));
    for (int32_t i = 0; i < tinker_scene_block_count(writer->scene); i++)
        add_block(writer, tinker_scene_block_at(writer->scene, i));
    tinker_writer_add_contacts(writer);
    tinker_writer_mark_redundant(writer);
    tinker_equations_bound_roundings(writer->equations);
}

TinkerEquations *tinker_equations_new(TinkerScene *scene, const TinkerModelState *state, GError **error)
{
    g_autoptr(TinkerFrame) start = tinker_frame_new(scene, error), frame = tinker_frame_new(scene, NULL);
    if (start == NULL || frame == NULL) return NULL;
    const double time_behind = tinker_frame_time_behind(frame, state->time);
    if (!tinker_frame_set_time(frame, state->time, error)) return NULL;
    TinkerEquations *equations = g_new0(TinkerEquations, 1);
    *equations = (TinkerEquations){
        .scene = scene,
        .time = state->time,
        .bodies = g_ptr_array_new_with_free_func(body_free),
        .symbols = g_ptr_array_new_with_free_func(symbol_free),
        .definitions = g_ptr_array_new_with_free_func(tinker_equation_definition_free),
        .constraints = g_ptr_array_new_with_free_func(constraint_free),
        .not_written = g_ptr_array_new_with_free_func(not_written_free),
        .lines = g_ptr_array_new_with_free_func(line_free),
        .pins = g_ptr_array_new_with_free_func(line_free),
        .rods = g_ptr_array_new_with_free_func(line_free),
        .looks = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, look_free),
        .taken = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
        .values = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
        .roundings = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free),
    };
    TinkerEquationWriter writer = {
        .equations = equations,
        .scene = scene,
        .state = state,
        .frame = frame,
        .start = start,
        .time_behind = time_behind,
        .indices = g_hash_table_new_full(NULL, NULL, NULL, g_free),
        .stems = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
        .by_name = g_hash_table_new(g_str_hash, g_str_equal),
        .points = tinker_writer_points_new(),
        .body_of = g_hash_table_new(NULL, NULL),
        .places = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL),
        .sampled = g_hash_table_new_full(g_str_hash, g_str_equal, NULL, g_free),
        .slopes = g_array_new(FALSE, FALSE, sizeof(TinkerRowSlope)),
    };
    write_all(&writer);
    g_array_unref(writer.slopes);
    GHashTable *const tables[] = {writer.indices, writer.stems,  writer.by_name, writer.points,
                                  writer.body_of, writer.places, writer.sampled};
    for (gsize i = 0; i < G_N_ELEMENTS(tables); i++)
        g_hash_table_unref(tables[i]);
    return equations;
}

void tinker_equations_free(TinkerEquations *equations)
{
    GPtrArray *const lists[] = {equations->bodies,      equations->symbols,     equations->definitions,
                                equations->constraints, equations->not_written, equations->lines,
                                equations->rods,        equations->pins};
    for (gsize i = 0; i < G_N_ELEMENTS(lists); i++)
        g_ptr_array_unref(lists[i]);
    g_hash_table_unref(equations->looks);
    g_hash_table_unref(equations->taken);
    g_hash_table_unref(equations->values);
    g_hash_table_unref(equations->roundings);
    g_free(equations);
}

const char *tinker_equation_unit(TinkerDimension dimension, gboolean energy)
{
    static const TinkerDimension of_both = {1, 2, -2, 0};
    return !energy && tinker_dimension_equal(dimension, of_both) ? "N m" : tinker_unit_si_symbol(dimension);
}
