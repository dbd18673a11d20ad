/* Block types: what the host reads out of a good one, and each way in which one can be malformed. */
#include <math.h>
#include <string.h>

#include "plugin/catalogue/catalogue.h"
#include "plugin/descriptor/block-class.h"
#include "plugin/descriptor/class-build.h"

/* A block type that can be spoilt: a connector with a property of every kind. */
typedef struct {
    TinkerPropertyType properties[8];
    TinkerQuantityType quantities[2];
    TinkerUnitChoice choices[2];
    TinkerBody body;
    TinkerLineLaw line_law;
    TinkerForceElement force_element;
    TinkerMotion motion;
    TinkerConstraint constraint;
    TinkerPhysics physics;
    TinkerRender render;
    TinkerEdit edit;
    TinkerUnits units;
    TinkerGraph graph;
    TinkerInterface interfaces[6];
    TinkerBlockType type;
} Model;

enum { STIFFNESS, REST, TURNS, SOLID, MODE, LABEL, PLACE, DRIVE };

static const char *const mode_texts[] = {"linear", "cubic", "linear"};

static TinkerStatus tension(TinkerBatch *batch, const double *length, const double *rate, double *tension_out)
{
    return TINKER_OK;
}

static TinkerStatus force(TinkerBatch *batch, const TinkerPoint *ends, double *result)
{
    return TINKER_OK;
}

static double next_blow(TinkerBatch *batch)
{
    return 0;
}

static TinkerStatus motion(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration)
{
    return TINKER_OK;
}

static TinkerStatus rows_at(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift)
{
    return TINKER_OK;
}

static TinkerStatus values(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values_out)
{
    return TINKER_OK;
}

static void draw(const TinkerInstance *instance, struct _cairo *cairo, const TinkerStyle *style) {}

static int32_t hit(const TinkerInstance *instance, double x, double y, double reach)
{
    return TINKER_PART_NONE;
}

static void move(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor) {}

static TinkerPropertyType property(const char *id, int32_t kind)
{
    return (TinkerPropertyType){.struct_size = sizeof(TinkerPropertyType), .kind = kind, .id = id, .panel = -1};
}

static void fill_properties(Model *model)
{
    TinkerPropertyType *properties = model->properties;
    properties[STIFFNESS] = property("stiffness", TINKER_KIND_REAL);
    properties[STIFFNESS].dimension = (TinkerDimension){1, 0, -2, 0};
    properties[STIFFNESS].flags = TINKER_HAS_MINIMUM;
    properties[REST] = property("rest", TINKER_KIND_REAL);
    properties[REST].dimension = (TinkerDimension){0, 1, 0, 0};
    properties[REST].flags = TINKER_DEFAULT_AS_PLACED;
    properties[REST].meaning = TINKER_MEANING_LENGTH;
    properties[TURNS] = property("turns", TINKER_KIND_INTEGER);
    properties[SOLID] = property("solid", TINKER_KIND_SWITCH);
    properties[MODE] = property("mode", TINKER_KIND_CHOICE);
    properties[MODE].choices = mode_texts;
    properties[MODE].choice_count = 2;
    properties[LABEL] = property("label", TINKER_KIND_TEXT);
    properties[PLACE] = property("place", TINKER_KIND_VECTOR);
    properties[PLACE].dimension = (TinkerDimension){0, 1, 0, 0};
    properties[DRIVE] = property("drive", TINKER_KIND_WAVEFORM);
    properties[DRIVE].amplitude = "stiffness";
}

static Model *model_new(void)
{
    Model *model = g_new0(Model, 1);
    fill_properties(model);
    for (int i = 0; i < 2; i++)
        model->quantities[i] =
            (TinkerQuantityType){.struct_size = sizeof(TinkerQuantityType), .id = i == 0 ? "tension" : "strain"};
    model->choices[0] = (TinkerUnitChoice){"stiffness", "kN/m", NULL};
    model->choices[1] = (TinkerUnitChoice){"rest", NULL, "in"};
    model->body = (TinkerBody){.struct_size = sizeof(TinkerBody), .degrees_of_freedom = 2};
    model->line_law = (TinkerLineLaw){.struct_size = sizeof(TinkerLineLaw), .tension = tension};
    model->force_element =
        (TinkerForceElement){.struct_size = sizeof(TinkerForceElement), .force = force, .next_blow = next_blow};
    model->motion = (TinkerMotion){.struct_size = sizeof(TinkerMotion), .motion = motion};
    model->constraint = (TinkerConstraint){.struct_size = sizeof(TinkerConstraint), .rows = 1, .rows_at = rows_at};
    model->physics = (TinkerPhysics){.struct_size = sizeof(TinkerPhysics), .line_law = &model->line_law};
    model->render = (TinkerRender){.struct_size = sizeof(TinkerRender), .draw = draw};
    model->edit = (TinkerEdit){.struct_size = sizeof(TinkerEdit), .hit = hit, .move = move, .move_absolute = move};
    model->units = (TinkerUnits){sizeof(TinkerUnits), 0, TINKER_SPAN(model->choices)};
    model->graph = (TinkerGraph){.struct_size = sizeof(TinkerGraph), .values = values};
    const TinkerInterface interfaces[6] = {
        {TINKER_PHYSICS_INTERFACE, &model->physics}, {TINKER_RENDER_INTERFACE, &model->render},
        {TINKER_EDIT_INTERFACE, &model->edit},       {TINKER_UNITS_INTERFACE, &model->units},
        {TINKER_GRAPH_INTERFACE, &model->graph},     {"com.example.sound/1", &model->body},
    };
    memcpy(model->interfaces, interfaces, sizeof interfaces);
    model->type = (TinkerBlockType){
        .struct_size = sizeof(TinkerBlockType),
        .schema_version = 1,
        .id = "pull",
        .title = "Pull",
        .category = TINKER_CONNECTOR,
        .least_ends = 2,
        .most_ends = 2,
        .end_accepts = TINKER_ACCEPTS_BODY,
        .properties = TINKER_SPAN(model->properties),
        .quantities = TINKER_SPAN(model->quantities),
        .interfaces = TINKER_SPAN(model->interfaces),
    };
    return model;
}

static const TinkerBlockClass *build(Model *model, GPtrArray *arena, GError **error)
{
    static const TinkerPlugin plugin = {TINKER_PLUGIN_HEAD, .id = "org.tinker.test.model"};
    return tinker_block_class_build(&model->type, &plugin, "/library.so", arena, error);
}

static void test_good(void)
{
    g_autofree Model *model = model_new();
    g_autoptr(GPtrArray) arena = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GError) error = NULL;
    const TinkerBlockClass *pull = build(model, arena, &error);
    g_assert_no_error(error);

    // Columns by the contract: real 1, integer 1, switch 1, choice 1, text 0, vector 2, waveform 3.
    static const int32_t first_columns[] = {0, 1, 2, 3, 4, 5, 5, 7};
    g_assert_cmpint(pull->property_count, ==, 8);
    g_assert_cmpmem(pull->first_columns, 8 * sizeof(int32_t), first_columns, sizeof first_columns);
    g_assert_cmpint(pull->column_count, ==, 10);
    g_assert_cmpint(pull->meanings[TINKER_MEANING_LENGTH], ==, REST);
    g_assert_cmpint(pull->meanings[TINKER_MEANING_MASS], ==, -1);
    g_assert_cmpint(tinker_block_class_meaning_column(pull, TINKER_MEANING_LENGTH), ==, 1);
    g_assert_cmpint(tinker_block_class_meaning_column(pull, TINKER_MEANING_MASS), ==, -1);
    g_assert_cmpint(tinker_block_class_meaning_column(pull, TINKER_MEANING_COUNT), ==, -1);
    g_assert_cmpint(tinker_block_class_property(pull, "drive"), ==, DRIVE);
    g_assert_cmpint(tinker_block_class_property(pull, "strain"), ==, -1);
    g_assert_cmpint(tinker_block_class_quantity(pull, "strain"), ==, 1);
    g_assert_cmpint(tinker_kind_columns(-1), ==, 0);
    g_assert_cmpint(tinker_kind_columns(99), ==, 0);
    g_assert_true(pull->physics != &model->physics && pull->physics->line_law->tension == tension);
}

static void test_units(void)
{
    g_autofree Model *model = model_new();
    g_autoptr(GPtrArray) arena = g_ptr_array_new_with_free_func(g_free);
    const TinkerBlockClass *pull = build(model, arena, NULL);
    const TinkerDimension stiffness = {1, 0, -2, 0}, length = {0, 1, 0, 0};
    g_assert_cmpstr(tinker_block_class_unit(pull, "stiffness", stiffness, 0), ==, "kN/m");
    g_assert_cmpstr(tinker_block_class_unit(pull, "stiffness", stiffness, 1), ==, "lbf/ft");
    g_assert_cmpstr(tinker_block_class_unit(pull, "rest", length, 0), ==, "m");
    g_assert_cmpstr(tinker_block_class_unit(pull, "rest", length, 1), ==, "in");
    g_assert_cmpstr(tinker_block_class_unit(pull, "place", length, 1), ==, "ft");
}

/* One fault: a statement that spoils `m`, and what is said of it. */
typedef struct {
    const char *name;
    void (*spoil)(Model *m);
    const char *message;
} Fault;

#define SPOIL(name, statement)                                                                                         \
    static void name(Model *m)                                                                                         \
    {                                                                                                                  \
        statement;                                                                                                     \
    }

SPOIL(spoil_category, m->type.category = "conector")
SPOIL(spoil_schema, m->type.schema_version = 0)
SPOIL(spoil_title, m->type.title = "\xff")
SPOIL(spoil_title_lines, m->type.title = "Two\nlines")
SPOIL(spoil_icon, m->type.icon_path = "../../etc/icon.svg")
SPOIL(spoil_least_ends, m->type.least_ends = -1)
SPOIL(spoil_most_ends, m->type.most_ends = 1)
SPOIL(spoil_accepts, m->type.end_accepts = 0)
SPOIL(spoil_stride, m->type.properties.stride = 12)
SPOIL(spoil_alignment, m->type.properties.stride = (int32_t)sizeof(TinkerPropertyType) + 1)
SPOIL(spoil_data, m->type.quantities.data = NULL)
SPOIL(spoil_size, m->properties[TURNS].struct_size = 8)
SPOIL(spoil_size_beyond_stride, m->properties[TURNS].struct_size = sizeof(TinkerPropertyType) + 8)
SPOIL(spoil_id, m->properties[TURNS].id = "")
SPOIL(spoil_id_null, m->properties[TURNS].id = NULL)
SPOIL(spoil_id_comma, m->properties[TURNS].id = "a,b")
SPOIL(spoil_id_twice, m->properties[TURNS].id = "mode")
SPOIL(spoil_id_key, m->properties[TURNS].id = "ends")
SPOIL(spoil_quantity_twice, m->quantities[1].id = "tension")
SPOIL(spoil_quantity_point, m->quantities[1].id = "x.y")
SPOIL(spoil_kind, m->properties[TURNS].kind = 7)
SPOIL(spoil_variability, m->properties[TURNS].variability = 3)
SPOIL(spoil_panel, m->properties[TURNS].panel = 2)
SPOIL(spoil_meaning, m->properties[TURNS].meaning = 99)
SPOIL(spoil_meaning_twice, m->properties[DRIVE].meaning = TINKER_MEANING_LENGTH)
SPOIL(spoil_meaning_kind, m->properties[STIFFNESS].meaning = TINKER_MEANING_POSITION)
SPOIL(spoil_meaning_unit, m->properties[STIFFNESS].meaning = TINKER_MEANING_MASS)
SPOIL(spoil_choice_count, m->properties[MODE].choice_count = -1)
SPOIL(spoil_no_choices, m->properties[MODE].choices = NULL)
SPOIL(spoil_choice_twice, m->properties[MODE].choice_count = 3)
SPOIL(spoil_choice_default, m->properties[MODE].default_value[0] = 2)
SPOIL(spoil_bounds, m->properties[STIFFNESS].flags |= TINKER_HAS_MAXIMUM; m->properties[STIFFNESS].hard_maximum = -1)
SPOIL(spoil_open_minimum, m->properties[STIFFNESS].flags |= TINKER_OPEN_MINIMUM)
SPOIL(spoil_soft, m->properties[STIFFNESS].flags |= TINKER_HAS_SOFT_RANGE)
SPOIL(spoil_default, m->properties[STIFFNESS].default_value[0] = -5)
SPOIL(spoil_default_nan, m->properties[PLACE].default_value[1] = NAN)
SPOIL(spoil_integer, m->properties[TURNS].default_value[0] = 0.5)
SPOIL(spoil_switch, m->properties[SOLID].default_value[0] = 2)
SPOIL(spoil_waveform, m->properties[DRIVE].default_text = "square")
SPOIL(spoil_frequency, m->properties[DRIVE].frequency = "omega")
SPOIL(spoil_phase, m->properties[DRIVE].phase = "mode")
SPOIL(spoil_same_as, m->properties[PLACE].flags = TINKER_DEFAULT_SAME_AS; m->properties[PLACE].default_from = "origin")
SPOIL(spoil_same_as_null, m->properties[PLACE].flags = TINKER_DEFAULT_SAME_AS)
SPOIL(spoil_same_as_kind, m->properties[PLACE].flags = TINKER_DEFAULT_SAME_AS;
      m->properties[PLACE].default_from = "stiffness")
SPOIL(spoil_same_as_itself, m->properties[PLACE].flags = TINKER_DEFAULT_SAME_AS;
      m->properties[PLACE].default_from = "place")
SPOIL(spoil_none, m->properties[PLACE].flags = TINKER_DEFAULT_NONE)
SPOIL(spoil_derived, m->properties[STIFFNESS].flags = TINKER_DERIVED)
SPOIL(spoil_as_placed, m->type.least_ends = 1)
SPOIL(spoil_interface_null, m->interfaces[5].vtable = NULL)
SPOIL(spoil_interface_twice, m->interfaces[5].id = TINKER_EDIT_INTERFACE)
SPOIL(spoil_interface_size, m->render.struct_size = 4)
SPOIL(spoil_interface_garbage, m->render.struct_size = 0x5a5a5a58)
SPOIL(spoil_interface_odd, m->render.struct_size = 13)
SPOIL(spoil_draw, m->render.draw = NULL)
SPOIL(spoil_hit, m->edit.hit = NULL)
SPOIL(spoil_values, m->graph.values = NULL)
SPOIL(spoil_graph, m->interfaces[4].id = "com.example.graph/1")
SPOIL(spoil_unit_id, m->choices[0].id = "force")
SPOIL(spoil_unit_dimension, m->choices[0].si = "kg")
SPOIL(spoil_scratch, m->physics.scratch_size = -8)
SPOIL(spoil_no_role, m->physics.line_law = NULL)
SPOIL(spoil_two_roles, m->physics.motion = &m->motion)
SPOIL(spoil_tension, m->line_law.tension = NULL)
SPOIL(spoil_blow, m->physics.line_law = NULL; m->physics.force_element = &m->force_element)
SPOIL(spoil_role_size, m->line_law.struct_size = 0)
SPOIL(spoil_rows, m->physics.line_law = NULL; m->physics.constraint = &m->constraint; m->constraint.rows = 0)
SPOIL(spoil_role_ends, m->physics.line_law = NULL; m->physics.motion = &m->motion)
SPOIL(spoil_body, m->physics.line_law = NULL; m->physics.body = &m->body)
SPOIL(spoil_body_mass, m->physics.line_law = NULL; m->physics.body = &m->body;
      m->properties[PLACE].meaning = TINKER_MEANING_POSITION)
SPOIL(spoil_body_role, m->physics.body = &m->body)
SPOIL(spoil_body_ends, m->physics.line_law = NULL; m->physics.body = &m->body; m->body.degrees_of_freedom = 0;
      m->properties[PLACE].meaning = TINKER_MEANING_POSITION)
SPOIL(spoil_freedoms, m->physics.line_law = NULL; m->physics.body = &m->body; m->body.degrees_of_freedom = 1)
SPOIL(spoil_shape, m->physics.line_law = NULL; m->physics.body = &m->body; m->body.shape = 5)

static const Fault faults[] = {
    {"category", spoil_category,
     "its category is \"conector\", one of connectable, connector, force, motion, field, joint, rope, measure was "
     "expected"},
    {"schema", spoil_schema, "its schema version is 0, at least 1 was expected"},
    {"title", spoil_title, "its title is not valid UTF-8"},
    {"title-lines", spoil_title_lines, "its title must be one line of text, because its blocks are named after it"},
    {"icon", spoil_icon, "its icon path \"../../etc/icon.svg\" leads out of the plugin's folder"},
    {"least-ends", spoil_least_ends, "its least number of ends is -1, at least 0 was expected"},
    {"most-ends", spoil_most_ends, "it has at least 2 and at most 1 ends (-1 stands for any number)"},
    {"accepts", spoil_accepts, "its ends accept neither bodies nor supports"},
    {"stride", spoil_stride, "the stride of properties is 12 bytes, at least 16 are needed"},
    {"alignment", spoil_alignment, "the stride of properties is 185 bytes, a multiple of 8 up to 65536 was expected"},
    {"data", spoil_data, "the data of 2 quantities is NULL"},
    {"size", spoil_size, "struct_size of properties is 8, at least 16 is needed"},
    {"size-beyond-stride", spoil_size_beyond_stride,
     "struct_size of properties is 192, more than their stride of 184 bytes"},
    {"id", spoil_id, "the id of property 2 is empty"},
    {"id-null", spoil_id_null, "the id of property 2 is NULL, a text was expected"},
    {"id-comma", spoil_id_comma, "the id of property 2 \"a,b\" must not contain \",\""},
    {"id-twice", spoil_id_twice, "two properties have the id \"mode\""},
    {"id-key", spoil_id_key, "a property has the id \"ends\", which is a key of every block in a scene"},
    {"quantity-twice", spoil_quantity_twice, "two quantities have the id \"tension\""},
    {"quantity-point", spoil_quantity_point, "the id of quantity 1 \"x.y\" must not contain \".\""},
    {"kind", spoil_kind, "property \"turns\": its kind is 7, 0 to 6 was expected"},
    {"variability", spoil_variability, "property \"turns\": its variability is 3, 0 to 2 was expected"},
    {"panel", spoil_panel,
     "property \"turns\": its panel is that of end 2, but the block has at most 2 ends (-1: its own panel)"},
    {"meaning", spoil_meaning, "property \"turns\": its meaning is 99, 0 to 19 was expected"},
    {"meaning-twice", spoil_meaning_twice,
     "property \"drive\": it means the length, and so does \"rest\"; one property may"},
    {"meaning-kind", spoil_meaning_kind,
     "property \"stiffness\": it means the position and is of kind real, vector was expected"},
    {"meaning-unit", spoil_meaning_unit,
     "property \"stiffness\": it means the mass and has the unit \"N/m\", \"kg\" was expected"},
    {"choice-count", spoil_choice_count, "property \"mode\": it has -1 choices, 0 to 1000 was expected"},
    {"no-choices", spoil_no_choices, "property \"mode\": it is a choice without choices"},
    {"choice-twice", spoil_choice_twice, "property \"mode\": the choice \"linear\" appears twice"},
    {"choice-default", spoil_choice_default,
     "property \"mode\": its default is choice 2, a whole number from 0 to 1 was expected"},
    {"bounds", spoil_bounds, "property \"stiffness\": its minimum 0 is above its maximum -1"},
    {"open-minimum", spoil_open_minimum, "property \"stiffness\": its default 0 lies outside its own range"},
    {"soft", spoil_soft, "property \"stiffness\": its soft minimum 0 is not below its soft maximum 0"},
    {"default", spoil_default, "property \"stiffness\": its default -5 lies outside its own range"},
    {"default-nan", spoil_default_nan, "property \"place\": its default is not a finite number"},
    {"integer", spoil_integer, "property \"turns\": its default is 0.5, a whole number was expected"},
    {"switch", spoil_switch, "property \"solid\": its default is 2, 0 or 1 was expected"},
    {"waveform", spoil_waveform,
     "property \"drive\": its default is the waveform \"square\", one of none, sine, cosine was expected"},
    {"frequency", spoil_frequency, "property \"drive\": its frequency is \"omega\", which is no property of the block"},
    {"phase", spoil_phase, "property \"drive\": its phase \"mode\" is not a real number"},
    {"same-as", spoil_same_as, "property \"place\": it defaults to \"origin\", which is no property of the block"},
    {"same-as-null", spoil_same_as_null,
     "property \"place\": the name of the property it defaults to is NULL, a text was expected"},
    {"same-as-kind", spoil_same_as_kind,
     "property \"place\": it defaults to \"stiffness\", which has another kind or unit"},
    {"same-as-itself", spoil_same_as_itself,
     "property \"place\": it defaults to \"place\", which itself defaults to another property"},
    {"none", spoil_none, "property \"place\": it may be left without a value and is of kind vector, real was expected"},
    {"derived", spoil_derived, "property \"stiffness\": it is derived, but the block has no quantity of this id"},
    {"as-placed", spoil_as_placed,
     "property \"rest\": it defaults to the length from end to end, but the block may have 1 (at least 2 ends are "
     "needed)"},
    {"interface-null", spoil_interface_null, "its interface \"com.example.sound/1\" is NULL"},
    {"interface-twice", spoil_interface_twice, "it offers \"tinker.edit/1\" twice"},
    {"interface-size", spoil_interface_size, "struct_size of \"tinker.render/1\" is 4, at least 8 is needed"},
    {"interface-garbage", spoil_interface_garbage,
     "struct_size of \"tinker.render/1\" is 1515870808, at most 65536 is allowed"},
    {"interface-odd", spoil_interface_odd, "struct_size of \"tinker.render/1\" is 13, a multiple of 8 was expected"},
    {"draw", spoil_draw, "its \"tinker.render/1\" lacks the required function \"draw\""},
    {"hit", spoil_hit, "its \"tinker.edit/1\" lacks the required function \"hit\""},
    {"values", spoil_values, "its \"tinker.graph/1\" lacks the required function \"values\""},
    {"graph", spoil_graph, "it has 2 quantities, but no \"tinker.graph/1\" that gives their values"},
    {"unit-id", spoil_unit_id, "a unit is chosen for \"force\", which is neither property nor quantity"},
    {"unit-dimension", spoil_unit_dimension,
     "the unit \"kg\" of \"stiffness\" has the dimension of \"kg\", that of \"N/m\" was expected"},
    {"scratch", spoil_scratch, "its physics asks for -8 bytes of scratch, 0 to 1073741824 was expected"},
    {"no-role", spoil_no_role, "its physics fills no role"},
    {"two-roles", spoil_two_roles, "its physics fills 2 roles, the body's and one more at most were expected"},
    {"tension", spoil_tension, "its line law lacks the required function \"tension\""},
    {"blow", spoil_blow, "its force element lacks the required function \"blow\""},
    {"role-size", spoil_role_size, "struct_size of TinkerLineLaw is 0, at least 8 is needed"},
    {"rows", spoil_rows, "its constraint has 0 rows, at least 1 was expected"},
    {"role-ends", spoil_role_ends, "it is a motion and has 2 to 2 ends, 1 was expected"},
    {"body-role", spoil_body_role,
     "it is a body and fills another role, that of a field alone goes with it (a field acts on all bodies, this one "
     "among them)"},
    {"body-ends", spoil_body_ends, "it is a body and has 2 to 2 ends, 0 was expected"},
    {"body", spoil_body, "it is a body, but no property means its position"},
    {"body-mass", spoil_body_mass, "it is a body, but no property means its mass"},
    {"freedoms", spoil_freedoms, "its body has 1 degrees of freedom, 0, 2 or 3 was expected"},
    {"shape", spoil_shape, "its body has the shape 5, 0 to 4 was expected"},
};

static void test_fault(gconstpointer data)
{
    const Fault *fault = data;
    g_autofree Model *model = model_new();
    g_autoptr(GPtrArray) arena = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GError) error = NULL;
    fault->spoil(model);
    g_assert_null(build(model, arena, &error));
    g_assert_error(error, TINKER_PLUGIN_ERROR, TINKER_PLUGIN_ERROR_REFUSED);
    g_autofree char *message = g_strconcat("block type \"pull\": ", fault->message, NULL);
    g_assert_cmpstr(error->message, ==, message);
}

int main(int count, char **arguments)
{
    g_test_init(&count, &arguments, NULL);
    g_test_add_func("/plugin/block-class/good", test_good);
    g_test_add_func("/plugin/block-class/units", test_units);
    for (gsize i = 0; i < G_N_ELEMENTS(faults); i++) {
        g_autofree char *path = g_strconcat("/plugin/block-class/", faults[i].name, NULL);
        g_test_add_data_func(path, &faults[i], test_fault);
    }
    return g_test_run();
}
