/* The functions over batches of a block type as one list, each with what it answers: of how many entries, and in which
 * dimension. Rules that hold for every function walk over it. */
#include <string.h>

#include "conformance/probe/state.h"

#define CALL(name, role, member, ...)                                                                                  \
    static TinkerStatus name(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)  \
    {                                                                                                                  \
        return block_class->physics->role->member(w->batch, __VA_ARGS__);                                              \
    }

CALL(call_tension, line_law, tension, w->lengths, w->rates, w->outputs[0])
CALL(call_line_derivatives, line_law, derivatives, w->lengths, w->rates, w->outputs[0], w->outputs[1])
CALL(call_line_energy, line_law, energy, w->lengths, w->outputs[0])
CALL(call_line_linear, line_law, linear, w->outputs[0], w->outputs[1], w->outputs[2], w->outputs[3])
CALL(call_force_energy, force_element, energy, w->points, w->outputs[0])
CALL(call_force_linear, force_element, linear, w->outputs[0], w->outputs[1], w->outputs[2])
CALL(call_torsion, force_element, torsion, w->outputs[0], w->outputs[1], w->outputs[2], w->outputs[3])
CALL(call_turning, constraint, turning, w->outputs[0])
CALL(call_friction, constraint, friction, w->outputs[0])
CALL(call_field_force, field, force, w->bodies, w->outputs[0])
CALL(call_field_energy, field, energy, w->bodies, w->outputs[0])
CALL(call_field_linear, field, linear, w->outputs[0])
CALL(call_field_derivatives, field, derivatives, w->bodies, w->outputs[0])
CALL(call_rotation, motion, rotation, w->outputs[0])
CALL(call_prescribed_rate, constraint, prescribed_rate, w->points, w->outputs[0])
CALL(call_scale, constraint, scale, w->outputs[0])
CALL(call_distance, constraint, distance, w->outputs[0])
CALL(call_motion, motion, motion, w->outputs[0], w->outputs[1], w->outputs[2])
CALL(call_motion_linear, motion, linear, w->outputs[0], w->outputs[1])

/* What speaks of angles answers that through the batch, as the last of its results. */
static TinkerStatus call_force(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)
{
    w->batch->angular = function->output_count > 1 ? w->outputs[1] : NULL;
    return block_class->physics->force_element->force(w->batch, w->points, w->outputs[0]);
}

static TinkerStatus call_blow(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)
{
    w->batch->angular = function->output_count > 1 ? w->outputs[1] : NULL;
    return block_class->physics->force_element->blow(w->batch, w->points, w->outputs[0]);
}

static TinkerStatus call_rows(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)
{
    w->batch->angular = function->output_count > 3 ? w->outputs[3] : NULL;
    return block_class->physics->constraint->rows_at(w->batch, w->points, w->outputs[0], w->outputs[1], w->outputs[2]);
}

static TinkerStatus call_values(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)
{
    return block_class->graph->values(w->batch, w->graph, function->quantity, w->outputs[0]);
}

/* A function that answers a time and no status. */
#define CALL_TIME(name, role, member)                                                                                  \
    static TinkerStatus name(const KitFunction *function, const TinkerBlockClass *block_class, const KitArguments *w)  \
    {                                                                                                                  \
        *(double *)w->outputs[0] = block_class->physics->role->member(w->batch);                                       \
        return TINKER_OK;                                                                                              \
    }

CALL_TIME(break_line_law, line_law, next_break)
CALL_TIME(break_force_element, force_element, next_break)
CALL_TIME(break_field, field, next_break)
CALL_TIME(break_constraint, constraint, next_break)
CALL_TIME(break_motion, motion, next_break)
CALL_TIME(call_next_blow, force_element, next_blow)

#define FORCE     TINKER_DIMENSION_FORCE
#define STIFFNESS TINKER_DIMENSION_STIFFNESS
#define DAMPING   TINKER_DIMENSION_DAMPING
#define LENGTH    TINKER_DIMENSION_LENGTH

static const KitFunction tension = {
    "tension", TRUE, FALSE, 0, 1, {{"tension", KIT_INSTANCES, 1, .dimension = {FORCE}}}, call_tension};
static const KitFunction line_derivatives = {
    "derivatives",
    TRUE,
    FALSE,
    0,
    2,
    {{"by_length", KIT_INSTANCES, 1, .dimension = {STIFFNESS}}, {"by_rate", KIT_INSTANCES, 1, .dimension = {DAMPING}}},
    call_line_derivatives};
static const KitFunction line_energy = {
    "energy",
    TRUE,
    FALSE,
    0,
    1,
    {{"stored", KIT_INSTANCES, 1, .absent = TRUE, .dimension = {TINKER_DIMENSION_ENERGY}}},
    call_line_energy};
static const KitFunction line_linear = {"linear",
                                        FALSE,
                                        TRUE,
                                        0,
                                        4,
                                        {{"stiffness", KIT_INSTANCES, 1, .dimension = {STIFFNESS}},
                                         {"damping", KIT_INSTANCES, 1, .dimension = {DAMPING}},
                                         {"length", KIT_INSTANCES, 1, .dimension = {LENGTH}},
                                         {"tension", KIT_INSTANCES, 1, .dimension = {FORCE}}},
                                        call_line_linear};
static const KitFunction force = {"force",   TRUE, FALSE, 0, 1, {{"force", KIT_ENDS, 2, .dimension = {FORCE, FORCE}}},
                                  call_force};
static const KitFunction blow = {
    "blow",   TRUE, FALSE,
    0,        1,    {{"impulse", KIT_ENDS, 2, .dimension = {TINKER_DIMENSION_MOMENTUM, TINKER_DIMENSION_MOMENTUM}}},
    call_blow};
static const KitFunction force_energy = {
    "energy",         TRUE, FALSE, 0, 1, {{"stored", KIT_INSTANCES, 1, .dimension = {TINKER_DIMENSION_ENERGY}}},
    call_force_energy};
static const KitFunction force_linear = {"linear",
                                         FALSE,
                                         TRUE,
                                         0,
                                         3,
                                         {{"constant", KIT_ENDS, 2, .dimension = {FORCE, FORCE}},
                                          {"direction", KIT_ENDS, 2},
                                          {"waveform_column", KIT_INSTANCES, 1, .integers = TRUE}},
                                         call_force_linear};
static const KitFunction torsion = {"torsion",
                                    FALSE,
                                    TRUE,
                                    0,
                                    4,
                                    {{"stiffness", KIT_INSTANCES, 1, .dimension = {TINKER_DIMENSION_ENERGY}},
                                     {"damping", KIT_INSTANCES, 1, .dimension = {{1, 2, -1, 0}}},
                                     {"rest", KIT_INSTANCES, 1, .dimension = {TINKER_DIMENSION_ANGLE}},
                                     {"waveform_column", KIT_INSTANCES, 1, .integers = TRUE}},
                                    call_torsion};
static const KitFunction turning = {"turning", FALSE, TRUE, 0, 1, {{"factors", KIT_ENDS, 1}}, call_turning};
static const KitFunction friction = {
    "friction", FALSE, FALSE, 0, 1, {{"arm", KIT_INSTANCES, 1, .dimension = {TINKER_DIMENSION_LENGTH}}}, call_friction};
static const KitFunction field_force = {
    "force", TRUE, FALSE, 0, 1, {{"force", KIT_BODIES, 2, .dimension = {FORCE, FORCE}}}, call_field_force};
static const KitFunction field_energy = {
    "energy",         TRUE, FALSE, 0, 1, {{"potential", KIT_ONCE, 1, .dimension = {TINKER_DIMENSION_ENERGY}}},
    call_field_energy};
/* TinkerLinearField: five doubles. */
static const KitFunction field_linear = {
    "linear",
    FALSE,
    TRUE,
    0,
    1,
    {{"law", KIT_INSTANCES, 5,
      .dimension = {TINKER_DIMENSION_ACCELERATION, TINKER_DIMENSION_ACCELERATION, FORCE, FORCE, DAMPING}}},
    call_field_linear};
static const KitFunction field_derivatives = {
    "derivatives",
    TRUE,
    FALSE,
    0,
    1,
    {{"jacobian", KIT_BODIES, 8,
      .dimension = {STIFFNESS, STIFFNESS, STIFFNESS, STIFFNESS, DAMPING, DAMPING, DAMPING, DAMPING}}},
    call_field_derivatives};
static const KitFunction rows = {
    "rows_at",
    TRUE,
    FALSE,
    0,
    3,
    {{"g", KIT_ROWS, 1, .of_g = TRUE},
     {"jacobian", KIT_ROW_ENDS, 2, .of_g = TRUE, .dimension = {{0, -1, 0, 0}, {0, -1, 0, 0}}},
     {"drift", KIT_ROWS, 1, .of_g = TRUE, .dimension = {{0, 0, -2, 0}}}},
    call_rows};
static const KitFunction prescribed_rate = {
    "prescribed_rate",   TRUE, FALSE, 0, 1, {{"rate", KIT_ROWS, 1, .of_g = TRUE, .dimension = {{0, 0, -1, 0}}}},
    call_prescribed_rate};
static const KitFunction scale = {
    "scale", FALSE, FALSE, 0, 1, {{"length", KIT_ROWS, 1, .tolerance = TRUE, .dimension = {LENGTH}}}, call_scale};
static const KitFunction distance = {
    "distance", FALSE, TRUE, 0, 1, {{"length", KIT_INSTANCES, 1, .dimension = {LENGTH}}}, call_distance};
static const KitFunction motion = {
    "motion",
    TRUE,
    FALSE,
    0,
    3,
    {{"displacement", KIT_INSTANCES, 2, .dimension = {LENGTH, LENGTH}},
     {"velocity", KIT_INSTANCES, 2, .dimension = {TINKER_DIMENSION_VELOCITY, TINKER_DIMENSION_VELOCITY}},
     {"acceleration", KIT_INSTANCES, 2, .dimension = {TINKER_DIMENSION_ACCELERATION, TINKER_DIMENSION_ACCELERATION}}},
    call_motion};
/* TinkerPose: three doubles. */
static const KitFunction rotation = {
    "rotation",
    TRUE,
    FALSE,
    0,
    1,
    {{"rotation", KIT_INSTANCES, 3, .dimension = {{0, 0, 0, 1}, {0, 0, -1, 1}, {0, 0, -2, 1}}}},
    call_rotation};
static const KitFunction motion_linear = {
    "linear",
    FALSE,
    TRUE,
    0,
    2,
    {{"direction", KIT_INSTANCES, 2}, {"waveform_column", KIT_INSTANCES, 1, .integers = TRUE}},
    call_motion_linear};

typedef TinkerStatus (*KitCall)(const KitFunction *, const TinkerBlockClass *, const KitArguments *);

static KitFunction next_time(const char *name, KitCall call)
{
    return (KitFunction){name, FALSE, FALSE,
                         0,    1,     {{"time", KIT_ONCE, 1, .infinite = TRUE, .dimension = {TINKER_DIMENSION_TIME}}},
                         call};
}

static KitFunction next_break(KitCall call)
{
    return next_time("next_break", call);
}

static void add(GArray *list, gboolean offered, KitFunction function)
{
    if (offered) g_array_append_val(list, function);
}

/* A direction times a waveform is a force, or a place: its dimension is that over the waveform's. */
static KitFunction with_direction(KitFunction function, int output, const TinkerBlockClass *block_class,
                                  TinkerDimension whole)
{
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        if (property->kind != TINKER_KIND_WAVEFORM) continue;
        whole.mass = (int8_t)(whole.mass - property->dimension.mass);
        whole.length = (int8_t)(whole.length - property->dimension.length);
        whole.time = (int8_t)(whole.time - property->dimension.time);
        break;
    }
    function.outputs[output].dimension[0] = function.outputs[output].dimension[1] = whole;
    return function;
}

static const KitOutput torque = {"torque", KIT_ENDS, 1, .angular = TRUE, .dimension = {TINKER_DIMENSION_ENERGY}};
static const KitOutput angular_impulse = {"angular impulse", KIT_ENDS, 1, .angular = TRUE,
                                          .dimension = {{1, 2, -1, 0}}};
static const KitOutput third_column = {"angular", KIT_ROW_ENDS, 1, .angular = TRUE, .of_g = TRUE};

static KitFunction with_output(KitFunction function, gboolean wanted, const KitOutput *output)
{
    if (wanted) function.outputs[function.output_count++] = *output;
    return function;
}

static void add_forces(GArray *list, const TinkerBlockClass *block_class)
{
    const TinkerLineLaw *line = block_class->physics->line_law;
    const TinkerForceElement *element = block_class->physics->force_element;
    if (line != NULL) {
        add(list, TRUE, tension);
        add(list, line->derivatives != NULL, line_derivatives);
        add(list, line->energy != NULL, line_energy);
        add(list, line->linear != NULL, line_linear);
        add(list, line->next_break != NULL, next_break(break_line_law));
    }
    if (element != NULL) {
        add(list, TRUE, with_output(force, element->angles != 0, &torque));
        add(list, element->energy != NULL, force_energy);
        add(list, element->linear != NULL,
            with_direction(force_linear, 1, block_class, (TinkerDimension)TINKER_DIMENSION_FORCE));
        add(list, element->torsion != NULL, torsion);
        add(list, element->next_break != NULL, next_break(break_force_element));
        add(list, element->next_blow != NULL, next_time("next_blow", call_next_blow));
        add(list, element->blow != NULL, with_output(blow, element->angles != 0, &angular_impulse));
    }
}

static void add_others(GArray *list, const TinkerBlockClass *block_class)
{
    const TinkerField *field = block_class->physics->field;
    const TinkerConstraint *constraint = block_class->physics->constraint;
    const TinkerMotion *role = block_class->physics->motion;
    if (field != NULL) {
        add(list, TRUE, field_force);
        add(list, field->energy != NULL, field_energy);
        add(list, field->linear != NULL, field_linear);
        add(list, field->derivatives != NULL, field_derivatives);
        add(list, field->next_break != NULL, next_break(break_field));
    }
    if (constraint != NULL) {
        add(list, TRUE, with_output(rows, constraint->angles != 0, &third_column));
        add(list, constraint->prescribed_rate != NULL, prescribed_rate);
        add(list, constraint->scale != NULL, scale);
        add(list, constraint->distance != NULL, distance);
        add(list, constraint->turning != NULL, turning);
        add(list, constraint->friction != NULL, friction);
        add(list, constraint->next_break != NULL, next_break(break_constraint));
    }
    if (role != NULL) {
        add(list, role->motion != NULL, motion);
        add(list, role->rotation != NULL, rotation);
        add(list, role->linear != NULL,
            with_direction(motion_linear, 0, block_class, (TinkerDimension)TINKER_DIMENSION_LENGTH));
        add(list, role->next_break != NULL, next_break(break_motion));
    }
}

GArray *kit_functions(const TinkerBlockClass *block_class)
{
    GArray *list = g_array_new(FALSE, TRUE, sizeof(KitFunction));
    if (block_class->physics != NULL) {
        add_forces(list, block_class);
        add_others(list, block_class);
    }
    for (int32_t i = 0; i < block_class->quantity_count; i++) {
        const TinkerQuantityType *quantity = &block_class->quantities[i];
        g_autofree char *name = g_strdup_printf("the quantity \"%s\"", quantity->id);
        KitFunction values = {.name = g_intern_string(name), .quantity = i, .output_count = 1, .call = call_values};
        values.outputs[0] = (KitOutput){"values", KIT_INSTANCES, 1, .dimension = {quantity->dimension}};
        g_array_append_val(list, values);
    }
    return list;
}

const KitFunction *kit_function(const GArray *functions, const char *name)
{
    for (guint i = 0; i < functions->len; i++) {
        const KitFunction *function = &g_array_index(functions, KitFunction, i);
        if (function->call != call_values && strcmp(function->name, name) == 0) return function;
    }
    return NULL;
}
