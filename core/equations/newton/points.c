/* Places: of bodies by their state, of supports by their properties and motions. */
#include <float.h>
#include <math.h>

#include "equations/newton/writer.h"
#include "law/build.h"

#include <tinker/kernels.h>

void tinker_point_symbols_clear(TinkerPointSymbols *point)
{
    g_clear_pointer(&point->x, tinker_expression_unref);
    g_clear_pointer(&point->y, tinker_expression_unref);
    g_clear_pointer(&point->vx, tinker_expression_unref);
    g_clear_pointer(&point->vy, tinker_expression_unref);
    g_clear_pointer(&point->angle, tinker_expression_unref);
    g_clear_pointer(&point->rate, tinker_expression_unref);
    g_clear_pointer(&point->arm_x, tinker_expression_unref);
    g_clear_pointer(&point->arm_y, tinker_expression_unref);
    g_clear_pointer(&point->local_x, tinker_expression_unref);
    g_clear_pointer(&point->local_y, tinker_expression_unref);
}

static void point_copy(TinkerPointSymbols *to, const TinkerPointSymbols *from)
{
    *to = (TinkerPointSymbols){.block = from->block,
                               .x = tinker_expression_ref(from->x),
                               .y = tinker_expression_ref(from->y),
                               .vx = tinker_expression_ref(from->vx),
                               .vy = tinker_expression_ref(from->vy),
                               .angle = tinker_expression_ref(from->angle),
                               .rate = tinker_expression_ref(from->rate)};
}

static void point_free(void *data)
{
    tinker_point_symbols_clear(data);
    g_free(data);
}

/* What motions do to a support: how far they move it, and turn it. */
enum { MOVED_X, MOVED_Y, TURNED, MOVES };

/* Adds one motion; answers FALSE where its law is not known. */
static gboolean add_motion(TinkerEquationWriter *writer, TinkerBlockId motion, TinkerExpression *moved[MOVES])
{
    static const char *const wanted[] = {"displacement_x", "displacement_y", "rotation"};
    g_autoptr(TinkerBlockLaw) law = tinker_block_law_new(tinker_scene_block_class(writer->scene, motion), 1, NULL);
    if (law == NULL) return FALSE;
    TinkerLawUse use;
    tinker_law_use_init(&use, motion, law);
    gboolean known = FALSE;
    for (int k = 0; k < MOVES; k++) {
        TinkerExpression *part = tinker_law_use_equation(writer, &use, wanted[k]);
        known = known || part != NULL;
        if (part != NULL) moved[k] = tinker_expression_plus(moved[k], part);
    }
    tinker_law_use_clear(&use);
    return known;
}

/* What all its motions together do, of which one does not tell its law: numbers, whose derivatives are numbers. */
static void move_by_numbers(TinkerEquationWriter *writer, TinkerBlockId support, TinkerBlockId motion,
                            TinkerExpression *moved[MOVES])
{
    static const char *const means[MOVES] = {"displacement in x", "displacement in y", "turned by"};
    const TinkerPlace *place = tinker_frame_motion(writer->frame, support);
    if (place == NULL) return;
    const TinkerSampledSymbol samples[MOVES] = {{.stem = "u",
                                                 .component = "x",
                                                 .values = {place->x, place->vx, place->ax},
                                                 .dimension = tinker_length_dimension},
                                                {.stem = "u",
                                                 .component = "y",
                                                 .values = {place->y, place->vy, place->ay},
                                                 .dimension = tinker_length_dimension},
                                                {.stem = "u",
                                                 .component = "φ",
                                                 .values = {place->angle, place->rate, place->angular_acceleration},
                                                 .dimension = tinker_angle_dimension}};
    for (int k = 0; k < (place->turns ? MOVES : TURNED); k++) {
        TinkerSampledSymbol sample = samples[k];
        sample.block = motion;
        sample.why = "its plugin states no law";
        tinker_expression_unref(moved[k]);
        moved[k] = tinker_writer_sampled(writer, &sample, means[k]);
    }
}

/* How all its motions move a support. */
static void moves_of(TinkerEquationWriter *writer, TinkerBlockId support, TinkerExpression *moved[MOVES])
{
    TinkerBlockId unknown = TINKER_NO_BLOCK;
    for (int32_t i = 0; i < tinker_scene_block_count(writer->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(writer->scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
        if (block_class == NULL || tinker_law_role(block_class) != TINKER_LAW_MOTION ||
            tinker_scene_end(writer->scene, block, 0).block != support)
            continue;
        if (!add_motion(writer, block, moved)) unknown = block;
    }
    if (unknown != TINKER_NO_BLOCK) move_by_numbers(writer, support, unknown, moved);
}

static gboolean is_typed(const TinkerEquationWriter *writer, const TinkerExpression *expression)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) {
        const TinkerEquationDefinition *definition = g_hash_table_lookup(writer->by_name, expression->name);
        return definition != NULL && definition->typed;
    }
    for (int i = 0; i < expression->count; i++)
        if (is_typed(writer, expression->parts[i])) return TRUE;
    return FALSE;
}

/* The place of a moved support and its velocity, or its angle and rate, as definitions. */
static void define_moved(TinkerEquationWriter *writer, TinkerBlockId support, const char *stem,
                         TinkerDimension dimension, TinkerExpression *place, TinkerExpression *displacement,
                         TinkerExpression **out, TinkerExpression **rate)
{
    const TinkerDimension of_rate = {dimension.mass, dimension.length, (int8_t)(dimension.time - 1), dimension.angle};
    const gboolean typed = is_typed(writer, displacement);
    if (tinker_expression_is_number(displacement, 0)) {
        tinker_expression_unref(displacement);
        *out = place;
        *rate = tinker_expression_number(0);
        return;
    }
    TinkerExpression *velocity = tinker_writer_rate(writer, displacement);
    const char *name = tinker_writer_name(writer, support, stem, 0, NULL);
    *out = tinker_writer_define(writer, name, support, dimension, "where its motion has it",
                                tinker_expression_plus(place, displacement), FALSE);
    name = tinker_writer_name(writer, support, stem, 1, NULL);
    *rate = tinker_writer_define(writer, name, support, of_rate, "its velocity", velocity, typed);
}

/* The centre of a support. */
static const TinkerPointSymbols *centre_of(TinkerEquationWriter *writer, TinkerBlockId support)
{
    TinkerPointSymbols *known = g_hash_table_lookup(writer->points, GINT_TO_POINTER(support));
    if (known != NULL) return known;
    static const char *const stems[] = {"X", "Y"}, *const placed[] = {"X0", "Y0"};
    TinkerExpression *moved_by[MOVES], *place[2], *rate[2];
    for (int k = 0; k < MOVES; k++)
        moved_by[k] = tinker_expression_number(0);
    moves_of(writer, support, moved_by);
    for (int axis = 0; axis < 2; axis++) {
        const gboolean moved = !tinker_expression_is_number(moved_by[axis], 0);
        TinkerExpression *start =
            tinker_writer_meaning(writer, support, TINKER_MEANING_POSITION, axis, moved ? placed[axis] : stems[axis]);
        define_moved(writer, support, stems[axis], tinker_length_dimension, start, moved_by[axis], &place[axis],
                     &rate[axis]);
    }
    TinkerPointSymbols *point = g_new(TinkerPointSymbols, 1);
    *point = (TinkerPointSymbols){.block = -1, .x = place[0], .y = place[1], .vx = rate[0], .vy = rate[1]};
    const gboolean turned = !tinker_expression_is_number(moved_by[TURNED], 0);
    TinkerExpression *placed_angle =
        tinker_writer_meaning(writer, support, TINKER_MEANING_ORIENTATION, 0, turned ? "φ0" : "φ");
    define_moved(writer, support, "φ", tinker_angle_dimension, placed_angle, moved_by[TURNED], &point->angle,
                 &point->rate);
    g_hash_table_insert(writer->points, GINT_TO_POINTER(support), point);
    return point;
}

/* A number that belongs to an end: how far a point is from its block's centre. */
static TinkerExpression *offset(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number,
                                const TinkerSceneEnd *end, gboolean along_x)
{
    const double value = along_x ? end->x : end->y;
    if (value == 0) return tinker_expression_number(0);
    g_autofree char *key = g_strdup_printf("ends %d at %s", number, along_x ? "x" : "y");
    g_autofree char *index = g_strdup_printf("%s%s%d", tinker_writer_index(writer, connector),
                                             tinker_writer_index(writer, connector)[0] != '\0' ? "," : "", number + 1);
    const char *name = tinker_equations_free_name(writer->equations, connector, "a", index, 0, along_x ? "x" : "y");
    tinker_equations_set_rounding(writer->equations, name, DBL_EPSILON * fmax(writer->extent, hypot(end->x, end->y)));
    return tinker_writer_symbol(writer, name, connector, value, tinker_length_dimension, key, NULL);
}

/* cos, or sin, of an angle: a number where that is exact and the angle is given, as of a support upside down. */
static TinkerExpression *component_of(const TinkerEquationWriter *writer, const TinkerExpression *angle, gboolean sine)
{
    const TinkerEquationSymbol *given =
        angle->kind == TINKER_EXPRESSION_SYMBOL ? tinker_equations_symbol(writer->equations, angle->name) : NULL;
    double direction[2] = {NAN, NAN};
    if (given != NULL && given->property != NULL) tinker_direction(given->value, direction);
    const gboolean exact = direction[0] == 0 || direction[1] == 0;
    return exact ? tinker_expression_number(direction[sine])
                 : tinker_expression_call(sine ? "sin" : "cos", tinker_expression_ref(angle));
}

/* The offset (a, b) turned by an angle. Uses a and b up; fills both components (transfer full). */
static void turn_offset(const TinkerEquationWriter *writer, const TinkerExpression *angle, TinkerExpression *a,
                        TinkerExpression *b, TinkerExpression *turned[2])
{
    TinkerExpression *c[2], *s[2];
    for (int i = 0; i < 2; i++) {
        c[i] = component_of(writer, angle, FALSE);
        s[i] = component_of(writer, angle, TRUE);
    }
    TinkerExpression *a_again = tinker_expression_ref(a), *b_again = tinker_expression_ref(b);
    turned[0] = tinker_expression_minus(tinker_expression_times(a, c[0]), tinker_expression_times(b, s[0]));
    turned[1] = tinker_expression_plus(tinker_expression_times(a_again, s[1]), tinker_expression_times(b_again, c[1]));
}

static TinkerExpression *state_of(const TinkerEquationWriter *writer, TinkerBlockId body, const char *quantity)
{
    g_autofree char *symbol = g_strconcat(tinker_scene_block_name(writer->scene, body), ".", quantity, NULL);
    return tinker_expression_symbol(symbol);
}

/* A definition of a connector's end on a body, which slopes take as it stands. */
static TinkerExpression *define_of_end(TinkerEquationWriter *writer, TinkerBlockId connector, const char *index,
                                       const char *stem, int dots, int axis, const char *means, TinkerExpression *is)
{
    static const char *const components[] = {"x", "y"};
    const TinkerDimension dimension = dots == 0 ? tinker_length_dimension : tinker_velocity_dimension;
    const char *name = tinker_equations_free_name(writer->equations, connector, stem, index, dots, components[axis]);
    g_hash_table_add(writer->places, g_strdup(name));
    return tinker_writer_define(writer, name, connector, dimension, means, is, FALSE);
}

/* A point off the centre of a body that turns: its arm r, its place, and its velocity v + omega x r. */
static void add_arm(TinkerEquationWriter *writer, TinkerPointSymbols *point, TinkerBlockId connector, int32_t number,
                    const TinkerSceneEnd *end)
{
    const char *of_connector = tinker_writer_index(writer, connector);
    g_autofree char *index = g_strdup_printf("%s%s%d", of_connector, of_connector[0] != '\0' ? "," : "", number + 1);
    TinkerExpression *arm[2], **const places[] = {&point->x, &point->y}, **const rates[] = {&point->vx, &point->vy};
    point->local_x = offset(writer, connector, number, end, TRUE);
    point->local_y = offset(writer, connector, number, end, FALSE);
    turn_offset(writer, point->angle, tinker_expression_ref(point->local_x), tinker_expression_ref(point->local_y),
                arm);
    for (int axis = 0; axis < 2; axis++)
        arm[axis] = define_of_end(writer, connector, index, "r", 0, axis, "arm from the centre of mass", arm[axis]);
    for (int axis = 0; axis < 2; axis++) {
        TinkerExpression *const along = tinker_expression_ref(arm[1 - axis]);
        TinkerExpression *turning = tinker_expression_times(tinker_expression_ref(point->rate), along);
        if (axis == 0) turning = tinker_expression_negated(turning);
        *places[axis] = define_of_end(writer, connector, index, "p", 0, axis, "where its end is",
                                      tinker_expression_plus(*places[axis], tinker_expression_ref(arm[axis])));
        *rates[axis] = define_of_end(writer, connector, index, "p", 1, axis, "velocity of that end",
                                     tinker_expression_plus(*rates[axis], turning));
    }
    point->arm_x = arm[0];
    point->arm_y = arm[1];
}

void tinker_writer_centre(TinkerEquationWriter *writer, TinkerBlockId block, TinkerPointSymbols *point)
{
    const TinkerBodyEquation *body = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(block));
    if (body == NULL) {
        point_copy(point, centre_of(writer, block));
        return;
    }
    const gboolean turns = body->inertia != NULL;
    *point = (TinkerPointSymbols){.block = block,
                                  .x = state_of(writer, block, "x"),
                                  .y = state_of(writer, block, "y"),
                                  .vx = state_of(writer, block, "vx"),
                                  .vy = state_of(writer, block, "vy")};
    point->angle = turns ? state_of(writer, block, "angle") : tinker_expression_number(0);
    point->rate = turns ? state_of(writer, block, "rate") : tinker_expression_number(0);
}

void tinker_writer_end(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number, TinkerPointSymbols *point)
{
    const TinkerSceneEnd end = tinker_scene_end(writer->scene, connector, number);
    const TinkerBodyEquation *body = g_hash_table_lookup(writer->body_of, GINT_TO_POINTER(end.block));
    tinker_writer_centre(writer, end.block, point);
    if (end.x == 0 && end.y == 0) return;
    if (body != NULL) {
        if (body->inertia != NULL) add_arm(writer, point, connector, number, &end);
        return;
    }
    TinkerExpression *turned[2];
    turn_offset(writer, point->angle, offset(writer, connector, number, &end, TRUE),
                offset(writer, connector, number, &end, FALSE), turned);
    TinkerExpression *across[2];
    for (int axis = 0; axis < 2; axis++)
        across[axis] = tinker_expression_times(tinker_expression_ref(point->rate), tinker_expression_ref(turned[axis]));
    point->x = tinker_expression_plus(point->x, turned[0]);
    point->y = tinker_expression_plus(point->y, turned[1]);
    point->vx = tinker_expression_minus(point->vx, across[1]);
    point->vy = tinker_expression_plus(point->vy, across[0]);
}

TinkerExpression *tinker_writer_start(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number,
                                      char quantity)
{
    static const char *const stems[] = {"x0", "y0", "θ0"}, *const means[] = {"x at the start", "y at the start",
                                                                             "angle at the start"};
    const TinkerSceneEnd end = tinker_scene_end(writer->scene, connector, number);
    const TinkerDimension dimension = quantity == 't' ? tinker_angle_dimension : tinker_length_dimension;
    const int which = quantity == 'x' ? 0 : quantity == 'y' ? 1 : 2;
    double at[3], centre[2];
    tinker_frame_end(writer->start, end, at);
    tinker_frame_centre(writer->start, end.block, &centre[0], &centre[1], &at[2]);
    const char *of_connector = tinker_writer_index(writer, connector);
    g_autofree char *index = g_strdup_printf("%s%s%d", of_connector, of_connector[0] != '\0' ? "," : "", number + 1);
    const char *name = tinker_equations_free_name(writer->equations, connector, stems[which], index, 0, NULL);
    return tinker_writer_symbol(writer, name, connector, at[which], dimension, NULL, means[which]);
}

GHashTable *tinker_writer_points_new(void)
{
    return g_hash_table_new_full(NULL, NULL, NULL, point_free);
}
