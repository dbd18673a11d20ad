/* Places: of bodies by their state, of supports by their properties and motions. */
#include <math.h>

#include "equations/writer-private.h"
#include "law/build.h"

void tinker_point_symbols_clear(TinkerPointSymbols *point)
{
    g_clear_pointer(&point->x, tinker_expression_unref);
    g_clear_pointer(&point->y, tinker_expression_unref);
    g_clear_pointer(&point->vx, tinker_expression_unref);
    g_clear_pointer(&point->vy, tinker_expression_unref);
}

static void point_copy(TinkerPointSymbols *to, const TinkerPointSymbols *from)
{
    *to = (TinkerPointSymbols){from->block, tinker_expression_ref(from->x), tinker_expression_ref(from->y),
                               tinker_expression_ref(from->vx), tinker_expression_ref(from->vy)};
}

static void point_free(void *data)
{
    tinker_point_symbols_clear(data);
    g_free(data);
}

/* Adds one motion to a displacement; answers FALSE where its law is not known. */
static gboolean add_motion(TinkerEquationWriter *writer, TinkerBlockId motion, TinkerExpression *displacement[2])
{
    static const char *const wanted[] = {"displacement_x", "displacement_y"};
    g_autoptr(TinkerBlockLaw) law = tinker_block_law_new(tinker_scene_block_class(writer->scene, motion), 1, NULL);
    if (law == NULL) return FALSE;
    TinkerLawUse use;
    tinker_law_use_init(&use, motion, law);
    gboolean known = TRUE;
    for (int axis = 0; axis < 2; axis++) {
        TinkerExpression *part = tinker_law_use_equation(writer, &use, wanted[axis]);
        known = known && part != NULL;
        if (part != NULL) displacement[axis] = tinker_expression_plus(displacement[axis], part);
    }
    tinker_law_use_clear(&use);
    return known;
}

/* The displacement of a support by all its motions; whether any moves it, and whether all are known. */
static void displacement_of(TinkerEquationWriter *writer, TinkerBlockId support, TinkerExpression *displacement[2],
                            gboolean *moves, TinkerBlockId *unknown)
{
    *moves = FALSE;
    *unknown = -1;
    for (int32_t i = 0; i < tinker_scene_block_count(writer->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(writer->scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
        if (block_class == NULL || tinker_law_role(block_class) != TINKER_LAW_MOTION ||
            tinker_scene_end(writer->scene, block, 0).block != support)
            continue;
        *moves = TRUE;
        if (!add_motion(writer, block, displacement)) *unknown = block;
    }
}

/* A support that moves as nobody says: its place is a number. */
static TinkerExpression *unknown_place(TinkerEquationWriter *writer, TinkerBlockId support, TinkerBlockId motion,
                                       const char *stem, double value)
{
    const char *name = tinker_writer_name(writer, support, stem, 0, NULL);
    tinker_writer_note_unwritten(writer, motion, name, "its plugin states no law");
    return tinker_writer_symbol(writer, name, support, value, tinker_length_dimension, NULL, stem);
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

/* The place and the velocity of a moved support as definitions. */
static void define_moved(TinkerEquationWriter *writer, TinkerBlockId support, const char *stem, TinkerExpression *place,
                         TinkerExpression *displacement, TinkerExpression **out, TinkerExpression **rate)
{
    const gboolean typed = is_typed(writer, displacement);
    if (tinker_expression_is_number(displacement, 0)) {
        tinker_expression_unref(displacement);
        *out = place;
        *rate = tinker_expression_number(0);
        return;
    }
    TinkerExpression *velocity = tinker_writer_rate(writer, displacement);
    const char *name = tinker_writer_name(writer, support, stem, 0, NULL);
    *out = tinker_writer_define(writer, name, support, tinker_length_dimension, "where its motion has it",
                                tinker_expression_plus(place, displacement), FALSE);
    name = tinker_writer_name(writer, support, stem, 1, NULL);
    *rate = tinker_writer_define(writer, name, support, tinker_velocity_dimension, "its velocity", velocity, typed);
}

/* The centre of a support. */
static const TinkerPointSymbols *centre_of(TinkerEquationWriter *writer, TinkerBlockId support)
{
    TinkerPointSymbols *known = g_hash_table_lookup(writer->points, GINT_TO_POINTER(support));
    if (known != NULL) return known;
    static const char *const stems[] = {"X", "Y"}, *const placed[] = {"X0", "Y0"};
    TinkerExpression *displacement[] = {tinker_expression_number(0), tinker_expression_number(0)}, *place[2], *rate[2];
    gboolean moves;
    TinkerBlockId unknown;
    double at[2], orientation;
    displacement_of(writer, support, displacement, &moves, &unknown);
    tinker_frame_centre(writer->frame, support, &at[0], &at[1], &orientation);
    for (int axis = 0; axis < 2; axis++) {
        if (unknown >= 0) {
            place[axis] = unknown_place(writer, support, unknown, stems[axis], at[axis]);
            rate[axis] = tinker_expression_number(0);
            tinker_expression_unref(displacement[axis]);
            continue;
        }
        const gboolean moved = !tinker_expression_is_number(displacement[axis], 0);
        TinkerExpression *start =
            tinker_writer_meaning(writer, support, TINKER_MEANING_POSITION, axis, moved ? placed[axis] : stems[axis]);
        define_moved(writer, support, stems[axis], start, displacement[axis], &place[axis], &rate[axis]);
    }
    TinkerPointSymbols *point = g_new(TinkerPointSymbols, 1);
    *point = (TinkerPointSymbols){-1, place[0], place[1], rate[0], rate[1]};
    g_hash_table_insert(writer->points, GINT_TO_POINTER(support), point);
    return point;
}

/* A number that belongs to an end: how far a point is from its block's centre. */
static TinkerExpression *offset(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number, double value,
                                gboolean along_x)
{
    if (value == 0) return tinker_expression_number(0);
    g_autofree char *key = g_strdup_printf("ends %d at %s", number, along_x ? "x" : "y");
    g_autofree char *index = g_strdup_printf("%s%s%d", tinker_writer_index(writer, connector),
                                             tinker_writer_index(writer, connector)[0] != '\0' ? "," : "", number);
    const char *name = tinker_writer_indexed_name(writer, connector, along_x ? "ax" : "ay", index, 0, NULL);
    return tinker_writer_symbol(writer, name, connector, value, tinker_length_dimension, key, NULL);
}

/* Turns the offset (a, b) by the block's angle and adds it to the point. Uses a and b up. */
static void add_offset(TinkerEquationWriter *writer, TinkerPointSymbols *point, TinkerBlockId block,
                       TinkerExpression *a, TinkerExpression *b)
{
    g_autoptr(TinkerExpression) angle = tinker_writer_meaning(writer, block, TINKER_MEANING_ORIENTATION, 0, "φ");
    TinkerExpression *c[2], *s[2];
    for (int i = 0; i < 2; i++) {
        c[i] = tinker_expression_call("cos", tinker_expression_ref(angle));
        s[i] = tinker_expression_call("sin", tinker_expression_ref(angle));
    }
    TinkerExpression *a_again = tinker_expression_ref(a), *b_again = tinker_expression_ref(b);
    point->x = tinker_expression_plus(
        point->x, tinker_expression_minus(tinker_expression_times(a, c[0]), tinker_expression_times(b, s[0])));
    point->y = tinker_expression_plus(point->y, tinker_expression_plus(tinker_expression_times(a_again, s[1]),
                                                                       tinker_expression_times(b_again, c[1])));
}

void tinker_writer_end(TinkerEquationWriter *writer, TinkerBlockId connector, int32_t number, TinkerPointSymbols *point)
{
    const TinkerSceneEnd end = tinker_scene_end(writer->scene, connector, number);
    if (g_hash_table_contains(writer->body_of, GINT_TO_POINTER(end.block))) {
        const char *name = tinker_scene_block_name(writer->scene, end.block);
        static const char *const quantities[] = {"x", "y", "vx", "vy"};
        TinkerExpression *parts[4];
        for (int i = 0; i < 4; i++) {
            g_autofree char *symbol = g_strconcat(name, ".", quantities[i], NULL);
            parts[i] = tinker_expression_symbol(symbol);
        }
        *point = (TinkerPointSymbols){end.block, parts[0], parts[1], parts[2], parts[3]};
        return;
    }
    point_copy(point, centre_of(writer, end.block));
    if (end.x == 0 && end.y == 0) return;
    add_offset(writer, point, end.block, offset(writer, connector, number, end.x, TRUE),
               offset(writer, connector, number, end.y, FALSE));
}

GHashTable *tinker_writer_points_new(void)
{
    return g_hash_table_new_full(NULL, NULL, NULL, point_free);
}

void tinker_writer_centre(TinkerEquationWriter *writer, TinkerBlockId support, TinkerPointSymbols *point)
{
    point_copy(point, centre_of(writer, support));
}
