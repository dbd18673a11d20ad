/* What the blocks declare: one exported symbol, nothing of ours linked, and properties exactly as the scene format and
 * the thesis's property panes have them. */
#include <elf.h>
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"

#define FREE        (-INFINITY)
#define RIGHT_ANGLE 1.57079632679489661923

/* A row of the scene format's table: default, unit, least value (open where nothing equal to it is allowed), panel. */
typedef struct {
    const char *block, *property, *title, *group;
    TinkerDimension dimension;
    double first, second; /* default */
    double least;
    gboolean open;
    double greatest;
    guint32 flags; /* of those that say where a default comes from */
    int32_t meaning;
    const char *text;
} Expected;

#define LENGTH                                                                                                         \
    {                                                                                                                  \
        0, 1, 0, 0                                                                                                     \
    }
#define SPEED                                                                                                          \
    {                                                                                                                  \
        0, 1, -1, 0                                                                                                    \
    }
#define FORCE                                                                                                          \
    {                                                                                                                  \
        1, 1, -2, 0                                                                                                    \
    }
#define ANGLE                                                                                                          \
    {                                                                                                                  \
        0, 0, 0, 1                                                                                                     \
    }
#define PURE                                                                                                           \
    {                                                                                                                  \
        0, 0, 0, 0                                                                                                     \
    }
#define TURN                                                                                                           \
    {                                                                                                                  \
        0, 0, -1, 1                                                                                                    \
    }

/* clang-format off */
static const Expected expected[] = {
    {"mass", "mass", "Mass", "Properties", {1, 0, 0, 0}, 1, 0, 0, TRUE, INFINITY, 0, TINKER_MEANING_MASS, NULL},
    {"mass", "position", "Position", "Global Position", LENGTH, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_POSITION, NULL},
    {"mass", "velocity", "Velocity", "Initial Velocity", SPEED, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_VELOCITY, NULL},
    {"mass", "local_origin", "Local Origin", "Offset (Local Coordinates)", LENGTH, 0, 0, FREE, FALSE, INFINITY, TINKER_DEFAULT_SAME_AS, TINKER_MEANING_LOCAL_ORIGIN, NULL},
    {"mass", "orientation", "Orientation", "Properties", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_ORIENTATION, NULL},
    {"mass", "width", "Width", "Size", LENGTH, 0.8, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_WIDTH, NULL},
    {"mass", "height", "Height", "Size", LENGTH, 0.8, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_HEIGHT, NULL},
    {"mass", "static_friction", "Static coefficient", "Friction", PURE, 0, 0, 0, FALSE, INFINITY, TINKER_DEFAULT_NONE, TINKER_MEANING_STATIC_FRICTION, NULL},
    {"mass", "dynamic_friction", "Dynamic coefficient", "Friction", PURE, 0, 0, 0, FALSE, INFINITY, TINKER_DEFAULT_NONE, TINKER_MEANING_DYNAMIC_FRICTION, NULL},
    {"mass", "restitution", "Restitution", "Properties", PURE, 0, 0, 0, FALSE, 1, TINKER_DEFAULT_NONE, TINKER_MEANING_RESTITUTION, NULL},
    {"mass", "collides", "Collides", "Properties", PURE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_COLLIDES, NULL},
    {"support", "position", "Position", "Global Position", LENGTH, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_POSITION, NULL},
    {"support", "local_origin", "Local Origin", "Offset (Local Coordinates)", LENGTH, 0, 0, FREE, FALSE, INFINITY, TINKER_DEFAULT_SAME_AS, TINKER_MEANING_LOCAL_ORIGIN, NULL},
    {"support", "orientation", "Orientation", "Properties", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_ORIENTATION, NULL},
    {"support", "width", "Width", "Size", LENGTH, 4, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_WIDTH, NULL},
    {"support", "height", "Height", "Size", LENGTH, 0.4, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_HEIGHT, NULL},
    {"support", "static_friction", "Static coefficient", "Friction", PURE, 0.5, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_STATIC_FRICTION, NULL},
    {"support", "dynamic_friction", "Dynamic coefficient", "Friction", PURE, 0.5, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_DYNAMIC_FRICTION, NULL},
    {"support", "restitution", "Restitution", "Properties", PURE, 0, 0, 0, FALSE, 1, 0, TINKER_MEANING_RESTITUTION, NULL},
    {"support", "solid", "Solid", "Properties", PURE, 1, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_SOLID, NULL},
    {"spring", "stiffness", "K", "Spring Properties", {1, 0, -2, 0}, 25, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"spring", "rest_length", "Undeformed Length", "Spring Properties", LENGTH, 0, 0, 0, FALSE, INFINITY, TINKER_DEFAULT_AS_PLACED, TINKER_MEANING_LENGTH, NULL},
    {"spring", "length", "Length", "Spring Properties", LENGTH, 0, 0, FREE, FALSE, INFINITY, TINKER_READ_ONLY | TINKER_DERIVED, TINKER_MEANING_NONE, NULL},
    {"damper", "damping", "C", "Damper Properties", {1, 0, -1, 0}, 1, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"rod", "length", "Length", "Rod Properties", LENGTH, 0, 0, 0, TRUE, INFINITY, TINKER_DEFAULT_AS_PLACED, TINKER_MEANING_LENGTH, NULL},
    {"rope", "length", "Length", "Rope", LENGTH, 0, 0, 0, TRUE, INFINITY, TINKER_DEFAULT_AS_PLACED, TINKER_MEANING_LENGTH, NULL},
    {"motor", "waveform", "Type", "Force", FORCE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, "cosine"},
    {"motor", "amplitude", "Amplitude", "Force", FORCE, 1, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"motor", "frequency", "Frequency", "Force", TURN, 1, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"motor", "phase", "Phase", "Force", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"motor", "angle", "Angle", "Force", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"motor", "follows", "Follows", "Force", PURE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"support-motion", "waveform", "Type", "Motion", LENGTH, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, "sine"},
    {"support-motion", "amplitude", "Amplitude", "Motion", LENGTH, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"support-motion", "frequency", "Frequency", "Motion", TURN, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"support-motion", "phase", "Phase", "Motion", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"support-motion", "angle", "Angle", "Motion", ANGLE, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"gravity", "acceleration", "Acceleration", "Gravity", {0, 1, -2, 0}, 9.81, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"gravity", "angle", "Angle", "Gravity", ANGLE, -RIGHT_ANGLE, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"wind", "velocity", "Velocity", "Wind", SPEED, 0, 0, FREE, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"wind", "drag", "Drag", "Wind", {1, 0, -1, 0}, 0, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
    {"wind", "drag_quadratic", "Quadratic Drag", "Wind", {1, -1, 0, 0}, 0, 0, 0, FALSE, INFINITY, 0, TINKER_MEANING_NONE, NULL},
};

/* What can be graphed, in words of the scene format; + marks what is recorded without being asked for. */
static const struct { const char *block, *quantities; } expected_quantities[] = {
    {"mass", "+x +y +vx +vy ax ay speed kinetic_energy x_momentum y_momentum normal_force friction_force contact_force acceleration"},
    {"support", "x y vx vy ax ay normal_force friction_force contact_force"},
    {"spring", "length extension +tension energy"},
    {"damper", "rate +tension dissipated_power"},
    {"rod", "+tension length_error"},
    {"motor", "force power"},
    {"support-motion", "displacement velocity acceleration"},
    {"gravity", "potential_energy"},
    {"wind", "power"},
    {"rope", "+tension slack"},
    {"marker", "+x +y +vx +vy speed ax ay"},
};
/* clang-format on */

/* The dynamic symbols and needed libraries of a library, read from its sections. */
static void read_dynamic(const char *path, GPtrArray *exported, GPtrArray *needed)
{
    g_autofree char *bytes = NULL;
    g_assert_true(g_file_get_contents(path, &bytes, NULL, NULL));
    const Elf64_Ehdr *header = (const void *)bytes;
    const Elf64_Shdr *sections = (const void *)(bytes + header->e_shoff);
    for (int s = 0; s < header->e_shnum; s++) {
        const char *strings = bytes + sections[sections[s].sh_link].sh_offset;
        if (sections[s].sh_type == SHT_DYNSYM) {
            const Elf64_Sym *symbols = (const void *)(bytes + sections[s].sh_offset);
            for (size_t k = 0; k < sections[s].sh_size / sizeof *symbols; k++) {
                if (symbols[k].st_shndx != SHN_UNDEF) g_ptr_array_add(exported, g_strdup(strings + symbols[k].st_name));
            }
        } else if (sections[s].sh_type == SHT_DYNAMIC) {
            const Elf64_Dyn *entries = (const void *)(bytes + sections[s].sh_offset);
            for (; entries->d_tag != DT_NULL; entries++) {
                if (entries->d_tag == DT_NEEDED) g_ptr_array_add(needed, g_strdup(strings + entries->d_un.d_val));
            }
        }
    }
}

static gboolean is_library_of_c(const char *name)
{
    /* The sanitizers' libraries come with a build that asks for them. */
    static const char *const allowed[] = {"libc.so",  "libm.so", "ld-linux", "libasan",
                                          "libubsan", "libtsan", "libgcc_s"};
    for (size_t i = 0; i < G_N_ELEMENTS(allowed); i++) {
        if (g_str_has_prefix(name, allowed[i])) return TRUE;
    }
    return FALSE;
}

static void test_symbols(gconstpointer data)
{
    g_autofree char *path = plugin_path(data);
    g_autoptr(GPtrArray) exported = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GPtrArray) needed = g_ptr_array_new_with_free_func(g_free);
    read_dynamic(path, exported, needed);
    g_assert_cmpuint(exported->len, ==, 1);
    g_assert_cmpstr(exported->pdata[0], ==, "tinker_plugin_v1");
    for (guint i = 0; i < needed->len; i++) {
        if (!is_library_of_c(needed->pdata[i])) g_error("%s needs %s", path, (const char *)needed->pdata[i]);
    }
}

static void test_plugin(gconstpointer data)
{
    const TinkerPlugin *plugin = plugin_open(data);
    g_assert_cmpuint(plugin->magic, ==, 0x544e4b52u);
    g_assert_cmpuint(plugin->struct_size, ==, sizeof(TinkerPlugin));
    g_assert_cmpint(plugin->size_of_double, ==, 8);
    g_assert_cmpint(plugin->size_of_index, ==, 4);
    g_assert_cmpint(plugin->least_host_minor, <=, TINKER_ABI_MINOR);
    g_autofree char *id = g_strconcat("org.tinker.", data, NULL);
    g_assert_cmpstr(plugin->id, ==, id);
    const TinkerBlockType *block = block_open(data);
    g_assert_cmpstr(block->id, ==, data);
    g_assert_cmpuint(block->struct_size, ==, sizeof(TinkerBlockType));
    g_assert_nonnull(block->summary);
}

static int roles(const TinkerPhysics *physics)
{
    return (physics->body != NULL) + (physics->line_law != NULL) + (physics->force_element != NULL) +
           (physics->field != NULL) + (physics->constraint != NULL) + (physics->motion != NULL);
}

static void test_interfaces(gconstpointer data)
{
    const TinkerBlockType *block = block_open(data);
    const gboolean acts = block_interface(block, TINKER_PHYSICS_INTERFACE) != NULL; /* a marker has no physics */
    g_assert_cmpint(block->interfaces.count, ==, acts ? 5 : 4);
    g_assert_cmpint(acts ? roles(block_physics(block)) : 1, ==, 1);
    const TinkerRender *render = block_interface(block, TINKER_RENDER_INTERFACE);
    const TinkerEdit *edit = block_interface(block, TINKER_EDIT_INTERFACE);
    const TinkerGraph *graph = block_interface(block, TINKER_GRAPH_INTERFACE);
    const TinkerUnits *units = block_interface(block, TINKER_UNITS_INTERFACE);
    g_assert_true(render != NULL && render->draw != NULL && render->bounds != NULL);
    g_assert_true(edit != NULL && edit->hit != NULL && edit->move != NULL && edit->move_absolute != NULL);
    g_assert_true(graph != NULL && graph->values != NULL);
    g_assert_true(units != NULL && units->choices.count > 0);
    const TinkerUnitChoice *choices = units->choices.data;
    for (int32_t i = 0; i < units->choices.count; i++) {
        gboolean known = FALSE;
        for (int32_t k = 0; k < block->properties.count; k++) {
            known |= strcmp(block_property(block, k)->id, choices[i].id) == 0;
        }
        for (int32_t k = 0; k < block->quantities.count; k++) {
            known |= strcmp(block_quantity(block, k)->id, choices[i].id) == 0;
        }
        g_assert_true(known);
    }
}

/* Every property of the table is there, in this order, and no other. */
static void test_properties(gconstpointer data)
{
    const TinkerBlockType *block = block_open(data);
    int32_t number = 0;
    for (size_t i = 0; i < G_N_ELEMENTS(expected); i++) {
        const Expected *row = &expected[i];
        if (strcmp(row->block, data) != 0) continue;
        const TinkerPropertyType *property = block_property(block, number++);
        g_assert_cmpstr(property->id, ==, row->property);
        g_assert_cmpstr(property->title, ==, row->title);
        g_assert_cmpstr(property->group, ==, row->group);
        g_assert_cmpmem(&property->dimension, sizeof(TinkerDimension), &row->dimension, sizeof(TinkerDimension));
        g_assert_cmpfloat(property->default_value[0], ==, row->first);
        g_assert_cmpfloat(property->default_value[1], ==, row->second);
        g_assert_cmpfloat(property->flags & TINKER_HAS_MINIMUM ? property->hard_minimum : FREE, ==, row->least);
        g_assert_cmpint((property->flags & TINKER_OPEN_MINIMUM) != 0, ==, row->open);
        g_assert_cmpfloat(property->flags & TINKER_HAS_MAXIMUM ? property->hard_maximum : INFINITY, ==, row->greatest);
        g_assert_cmpuint(property->flags & (TINKER_READ_ONLY | TINKER_DERIVED | TINKER_DEFAULT_AS_PLACED |
                                            TINKER_DEFAULT_SAME_AS | TINKER_DEFAULT_NONE),
                         ==, row->flags);
        g_assert_cmpint(property->meaning, ==, row->meaning);
        g_assert_cmpstr(property->default_text, ==, row->text);
        g_assert_cmpint(property->panel, ==, strcmp(data, "support-motion") == 0 ? 0 : -1);
        g_assert_nonnull(property->description);
    }
    g_assert_cmpint(block->properties.count, ==, number);
}

static void test_quantities(gconstpointer data)
{
    const TinkerBlockType *block = block_open(data);
    g_autoptr(GString) found = g_string_new(NULL);
    for (int32_t i = 0; i < block->quantities.count; i++) {
        const TinkerQuantityType *quantity = block_quantity(block, i);
        g_autofree char *id = g_strdelimit(g_strdup(quantity->id), " ", '_');
        g_string_append_printf(found, "%s%s%s", i > 0 ? " " : "", quantity->flags & TINKER_RECORDED ? "+" : "", id);
        g_assert_nonnull(quantity->title);
    }
    for (size_t i = 0; i < G_N_ELEMENTS(expected_quantities); i++) {
        if (strcmp(expected_quantities[i].block, data) == 0) {
            g_assert_cmpstr(found->str, ==, expected_quantities[i].quantities);
            return;
        }
    }
    g_assert_not_reached();
}

/* The header of the thesis's CSV file is "Time,Y Position". */
static void test_titles_of_a_mass(void)
{
    static const char *const titles[] = {"X Position", "Y Position",     "X Velocity",
                                         "Y Velocity", "X Acceleration", "Y Acceleration"};
    for (int32_t i = 0; i < 6; i++) {
        g_assert_cmpstr(block_quantity(block_open("mass"), i)->title, ==, titles[i]);
        g_assert_cmpstr(block_quantity(block_open("support"), i)->title, ==, titles[i]);
    }
    const TinkerPropertyType *velocity = block_property(block_open("mass"), 2);
    g_assert_cmpstr(velocity->component_titles[0], ==, "Vx");
    g_assert_cmpstr(velocity->component_titles[1], ==, "Vy");
}

static void test_ends(void)
{
    const guint32 both = TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT;
    const struct {
        const char *block, *category;
        int32_t ends;
        guint32 accepts;
    } rows[] = {
        {"mass", "connectable", 0, 0},
        {"support", "connectable", 0, 0},
        {"spring", "connector", 2, both},
        {"damper", "connector", 2, both},
        {"rod", "connector", 2, both},
        {"motor", "force", 1, TINKER_ACCEPTS_BODY},
        {"support-motion", "motion", 1, TINKER_ACCEPTS_SUPPORT},
        {"gravity", "field", 0, 0},
        {"wind", "field", 0, 0},
        {"marker", "measure", 1, both},
    };
    const TinkerBlockType *rope = block_open("rope");
    g_assert_cmpstr(rope->category, ==, "rope");
    g_assert_cmpint(rope->least_ends, ==, 2);
    g_assert_cmpint(rope->most_ends, ==, -1);
    g_assert_cmpuint(rope->end_accepts, ==, both);
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        const TinkerBlockType *block = block_open(rows[i].block);
        g_assert_cmpstr(block->category, ==, rows[i].category);
        g_assert_cmpint(block->least_ends, ==, rows[i].ends);
        g_assert_cmpint(block->most_ends, ==, rows[i].ends);
        g_assert_cmpuint(block->end_accepts, ==, rows[i].accepts);
    }
    g_assert_cmpint(block_physics(block_open("mass"))->body->degrees_of_freedom, ==, 2);
    g_assert_cmpint(block_physics(block_open("mass"))->body->shape, ==, TINKER_SHAPE_BOX);
    g_assert_cmpint(block_physics(block_open("support"))->body->degrees_of_freedom, ==, 0);
    g_assert_cmpint(block_physics(block_open("support"))->body->shape, ==, TINKER_SHAPE_PLATE);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    const struct {
        const char *name;
        GTestDataFunc function;
    } tests[] = {{"symbols", test_symbols},
                 {"plugin", test_plugin},
                 {"interfaces", test_interfaces},
                 {"properties", test_properties},
                 {"quantities", test_quantities}};
    for (int k = 0; block_names[k] != NULL; k++) {
        for (size_t i = 0; i < G_N_ELEMENTS(tests); i++) {
            g_autofree char *path = g_strdup_printf("/plugins/%s/%s", block_names[k], tests[i].name);
            g_test_add_data_func(path, block_names[k], tests[i].function);
        }
    }
    g_test_add_func("/plugins/titles-of-a-mass", test_titles_of_a_mass);
    g_test_add_func("/plugins/ends", test_ends);
    return g_test_run();
}
