/* The layout of every struct that crosses the boundary, on 64 bits: what a library that was compiled with the first
 * headers believes. A line here never changes; a member that is appended adds a line and a new size. */
#include <glib.h>
#include <string.h>

#include <tinker/sdk.h>

/* clang-format off */
#if UINTPTR_MAX == UINT64_MAX
#define SIZE(type, bytes)       _Static_assert(sizeof(type) == (bytes), "size of " #type);
#define AT(type, member, place) _Static_assert(offsetof(type, member) == (place), "place of " #type "." #member);

/* block.h */
SIZE(TinkerPropertyType, 184) AT(TinkerPropertyType, struct_size, 0) AT(TinkerPropertyType, kind, 4)
AT(TinkerPropertyType, id, 8) AT(TinkerPropertyType, title, 16) AT(TinkerPropertyType, group, 24)
AT(TinkerPropertyType, symbol, 32) AT(TinkerPropertyType, description, 40) AT(TinkerPropertyType, dimension, 48)
AT(TinkerPropertyType, flags, 52) AT(TinkerPropertyType, meaning, 56) AT(TinkerPropertyType, variability, 60)
AT(TinkerPropertyType, panel, 64) AT(TinkerPropertyType, choice_count, 68) AT(TinkerPropertyType, choices, 72)
AT(TinkerPropertyType, default_value, 80) AT(TinkerPropertyType, hard_minimum, 96)
AT(TinkerPropertyType, hard_maximum, 104) AT(TinkerPropertyType, soft_minimum, 112)
AT(TinkerPropertyType, soft_maximum, 120) AT(TinkerPropertyType, default_text, 128)
AT(TinkerPropertyType, default_from, 136) AT(TinkerPropertyType, component_titles, 144)
AT(TinkerPropertyType, amplitude, 160) AT(TinkerPropertyType, frequency, 168) AT(TinkerPropertyType, phase, 176)
SIZE(TinkerQuantityType, 40) AT(TinkerQuantityType, struct_size, 0) AT(TinkerQuantityType, flags, 4)
AT(TinkerQuantityType, id, 8) AT(TinkerQuantityType, title, 16) AT(TinkerQuantityType, description, 24)
AT(TinkerQuantityType, dimension, 32) AT(TinkerQuantityType, reserved, 36)
SIZE(TinkerBlockType, 136) AT(TinkerBlockType, struct_size, 0) AT(TinkerBlockType, schema_version, 4)
AT(TinkerBlockType, id, 8) AT(TinkerBlockType, title, 16) AT(TinkerBlockType, category, 24)
AT(TinkerBlockType, summary, 32) AT(TinkerBlockType, icon_path, 40)
AT(TinkerBlockType, help_link, 48) AT(TinkerBlockType, least_ends, 56) AT(TinkerBlockType, most_ends, 60)
AT(TinkerBlockType, end_accepts, 64) AT(TinkerBlockType, flags, 68) AT(TinkerBlockType, properties, 72)
AT(TinkerBlockType, quantities, 88) AT(TinkerBlockType, interfaces, 104) AT(TinkerBlockType, law, 120)

SIZE(TinkerPointList, 16) AT(TinkerPointList, points, 0) AT(TinkerPointList, count, 8)
AT(TinkerPointList, reserved, 12)
SIZE(TinkerBatch, 160) AT(TinkerBatch, struct_size, 0) AT(TinkerBatch, first, 4) AT(TinkerBatch, count, 8)
AT(TinkerBatch, ends, 12) AT(TinkerBatch, end_offsets, 16) AT(TinkerBatch, columns, 24) AT(TinkerBatch, scratch, 32)
AT(TinkerBatch, time, 40) AT(TinkerBatch, origin, 48) AT(TinkerBatch, failed_instance, 64)
AT(TinkerBatch, law_count, 68) AT(TinkerBatch, failure, 72) AT(TinkerBatch, laws, 80)
AT(TinkerBatch, end_masses, 88) AT(TinkerBatch, poses, 96) AT(TinkerBatch, placed, 104)
AT(TinkerBatch, placed_poses, 112) AT(TinkerBatch, has_angle, 120) AT(TinkerBatch, placed_columns, 128)
AT(TinkerBatch, angular, 136) AT(TinkerBatch, point_lists, 144) AT(TinkerBatch, point_list_count, 152)
AT(TinkerBatch, reserved, 156)

/* law.h */
SIZE(TinkerLawEquation, 40) AT(TinkerLawEquation, struct_size, 0) AT(TinkerLawEquation, reserved, 4)
AT(TinkerLawEquation, symbol, 8) AT(TinkerLawEquation, is, 16) AT(TinkerLawEquation, means, 24)
AT(TinkerLawEquation, dimension, 32) AT(TinkerLawEquation, reserved_2, 36)

/* edit.h */
SIZE(TinkerEditor, 32) AT(TinkerEditor, struct_size, 0) AT(TinkerEditor, reserved, 4) AT(TinkerEditor, context, 8)
AT(TinkerEditor, set, 16) AT(TinkerEditor, set_end, 24)
SIZE(TinkerHandle, 24) AT(TinkerHandle, x, 0) AT(TinkerHandle, y, 8) AT(TinkerHandle, part, 16)
AT(TinkerHandle, reserved, 20)
SIZE(TinkerEdit, 40) AT(TinkerEdit, struct_size, 0) AT(TinkerEdit, reserved, 4) AT(TinkerEdit, hit, 8)
AT(TinkerEdit, move, 16) AT(TinkerEdit, move_absolute, 24) AT(TinkerEdit, handles, 32)

/* graph.h */
SIZE(TinkerGraphInput, 88) AT(TinkerGraphInput, struct_size, 0) AT(TinkerGraphInput, reserved, 4)
AT(TinkerGraphInput, ends, 8) AT(TinkerGraphInput, accelerations, 16) AT(TinkerGraphInput, multipliers, 24)
AT(TinkerGraphInput, forces, 32) AT(TinkerGraphInput, bodies, 40) AT(TinkerGraphInput, masses, 48)
AT(TinkerGraphInput, body_count, 56) AT(TinkerGraphInput, reserved2, 60) AT(TinkerGraphInput, contacts, 64)
AT(TinkerGraphInput, poses, 72) AT(TinkerGraphInput, torques, 80)
SIZE(TinkerGraph, 16) AT(TinkerGraph, struct_size, 0) AT(TinkerGraph, reserved, 4) AT(TinkerGraph, values, 8)

/* instance.h */
SIZE(TinkerEnd, 32) AT(TinkerEnd, x, 0) AT(TinkerEnd, y, 8) AT(TinkerEnd, attached, 16) AT(TinkerEnd, reserved, 20)
AT(TinkerEnd, angle, 24)
SIZE(TinkerInstance, 120) AT(TinkerInstance, struct_size, 0) AT(TinkerInstance, ends, 4) AT(TinkerInstance, name, 8)
AT(TinkerInstance, columns, 16) AT(TinkerInstance, end, 24) AT(TinkerInstance, x, 32) AT(TinkerInstance, y, 40)
AT(TinkerInstance, orientation, 48) AT(TinkerInstance, time, 56) AT(TinkerInstance, symbol_size, 64)
AT(TinkerInstance, path, 72) AT(TinkerInstance, path_count, 80) AT(TinkerInstance, point_list_count, 84)
AT(TinkerInstance, point_lists, 88)
AT(TinkerInstance, text_count, 96) AT(TinkerInstance, texts, 104) AT(TinkerInstance, span, 112)

/* integrator.h */
SIZE(TinkerPattern, 24) AT(TinkerPattern, size, 0) AT(TinkerPattern, entries, 4) AT(TinkerPattern, row_starts, 8)
AT(TinkerPattern, columns, 16)
SIZE(TinkerLinearEdge, 40) AT(TinkerLinearEdge, a, 0) AT(TinkerLinearEdge, b, 4) AT(TinkerLinearEdge, stiffness, 8)
AT(TinkerLinearEdge, length, 16) AT(TinkerLinearEdge, damping, 24) AT(TinkerLinearEdge, tension, 32)
SIZE(TinkerSignal, 48) AT(TinkerSignal, kind, 0) AT(TinkerSignal, reserved, 4) AT(TinkerSignal, origin, 8)
AT(TinkerSignal, coefficient, 16)
SIZE(TinkerSignalUse, 24) AT(TinkerSignalUse, target, 0) AT(TinkerSignalUse, signal, 4) AT(TinkerSignalUse, book, 8)
AT(TinkerSignalUse, reserved, 12) AT(TinkerSignalUse, factor, 16)
SIZE(TinkerConstantLoad, 16) AT(TinkerConstantLoad, target, 0) AT(TinkerConstantLoad, book, 4)
AT(TinkerConstantLoad, force, 8)
SIZE(TinkerLinearSystem, 104) AT(TinkerLinearSystem, struct_size, 0) AT(TinkerLinearSystem, size, 4)
AT(TinkerLinearSystem, edge_count, 8) AT(TinkerLinearSystem, anchor_count, 12)
AT(TinkerLinearSystem, signal_count, 16) AT(TinkerLinearSystem, load_count, 20)
AT(TinkerLinearSystem, force_count, 24) AT(TinkerLinearSystem, motion_count, 28) AT(TinkerLinearSystem, mass, 32)
AT(TinkerLinearSystem, drag, 40) AT(TinkerLinearSystem, edges, 48) AT(TinkerLinearSystem, anchors, 56)
AT(TinkerLinearSystem, loads, 64) AT(TinkerLinearSystem, forces, 72) AT(TinkerLinearSystem, motions, 80)
AT(TinkerLinearSystem, damper_book, 88) AT(TinkerLinearSystem, drag_book, 92) AT(TinkerLinearSystem, support_book, 96)
AT(TinkerLinearSystem, reserved, 100)
SIZE(TinkerSystem, 136) AT(TinkerSystem, struct_size, 0) AT(TinkerSystem, flags, 4) AT(TinkerSystem, size, 8)
AT(TinkerSystem, books, 12) AT(TinkerSystem, context, 16) AT(TinkerSystem, mass, 24)
AT(TinkerSystem, acceleration, 32) AT(TinkerSystem, applied, 40) AT(TinkerSystem, project, 48)
AT(TinkerSystem, constrain_step, 56) AT(TinkerSystem, project_velocity, 64) AT(TinkerSystem, damping_product, 72)
AT(TinkerSystem, scales, 80) AT(TinkerSystem, failure, 88)
AT(TinkerSystem, pattern, 96) AT(TinkerSystem, jacobian, 104) AT(TinkerSystem, linear, 112)
AT(TinkerSystem, signals, 120) AT(TinkerSystem, row_masses, 128)
SIZE(TinkerState, 32) AT(TinkerState, t, 0) AT(TinkerState, q, 8) AT(TinkerState, v, 16) AT(TinkerState, books, 24)
SIZE(TinkerIntegratorOptions, 32) AT(TinkerIntegratorOptions, struct_size, 0) AT(TinkerIntegratorOptions, reserved, 4)
AT(TinkerIntegratorOptions, tolerance, 8) AT(TinkerIntegratorOptions, first_step, 16)
AT(TinkerIntegratorOptions, spectral_radius, 24)
SIZE(TinkerStepReport, 40) AT(TinkerStepReport, struct_size, 0) AT(TinkerStepReport, rejected, 4)
AT(TinkerStepReport, t_from, 8) AT(TinkerStepReport, step, 16) AT(TinkerStepReport, error, 24)
AT(TinkerStepReport, failure, 32)
SIZE(TinkerIntegrator, 112) AT(TinkerIntegrator, struct_size, 0) AT(TinkerIntegrator, flags, 4)
AT(TinkerIntegrator, id, 8) AT(TinkerIntegrator, title, 16) AT(TinkerIntegrator, summary, 24)
AT(TinkerIntegrator, source, 32) AT(TinkerIntegrator, order, 40) AT(TinkerIntegrator, dense_order, 44)
AT(TinkerIntegrator, evaluations_per_step, 48) AT(TinkerIntegrator, reserved, 52)
AT(TinkerIntegrator, imaginary_limit, 56) AT(TinkerIntegrator, real_limit, 64) AT(TinkerIntegrator, create, 72)
AT(TinkerIntegrator, destroy, 80) AT(TinkerIntegrator, restart, 88) AT(TinkerIntegrator, step, 96)
AT(TinkerIntegrator, interpolate, 104)

/* physics.h */
SIZE(TinkerBody, 24) AT(TinkerBody, struct_size, 0) AT(TinkerBody, degrees_of_freedom, 4) AT(TinkerBody, shape, 8)
AT(TinkerBody, reserved, 12) AT(TinkerBody, as_shaped, 16)
SIZE(TinkerLineLaw, 48) AT(TinkerLineLaw, struct_size, 0) AT(TinkerLineLaw, partly_stores, 4) AT(TinkerLineLaw, tension, 8)
AT(TinkerLineLaw, derivatives, 16) AT(TinkerLineLaw, energy, 24) AT(TinkerLineLaw, linear, 32)
AT(TinkerLineLaw, next_break, 40)
SIZE(TinkerForceElement, 72) AT(TinkerForceElement, struct_size, 0) AT(TinkerForceElement, angles, 4)
AT(TinkerForceElement, force, 8) AT(TinkerForceElement, energy, 16) AT(TinkerForceElement, linear, 24)
AT(TinkerForceElement, next_break, 32) AT(TinkerForceElement, dissipates, 40)
AT(TinkerForceElement, reserved, 44)
AT(TinkerForceElement, next_blow, 48) AT(TinkerForceElement, blow, 56)
AT(TinkerForceElement, torsion, 64)
SIZE(TinkerBodies, 32) AT(TinkerBodies, struct_size, 0) AT(TinkerBodies, count, 4) AT(TinkerBodies, points, 8)
AT(TinkerBodies, masses, 16) AT(TinkerBodies, first, 24) AT(TinkerBodies, range, 28)
SIZE(TinkerLinearField, 40) AT(TinkerLinearField, acceleration, 0) AT(TinkerLinearField, force, 16)
AT(TinkerLinearField, drag, 32)
SIZE(TinkerField, 48) AT(TinkerField, struct_size, 0) AT(TinkerField, couples_bodies, 4) AT(TinkerField, force, 8)
AT(TinkerField, energy, 16) AT(TinkerField, linear, 24) AT(TinkerField, next_break, 32)
AT(TinkerField, derivatives, 40)
SIZE(TinkerConstraint, 88) AT(TinkerConstraint, struct_size, 0) AT(TinkerConstraint, rows, 4)
AT(TinkerConstraint, unilateral, 8) AT(TinkerConstraint, joint, 12) AT(TinkerConstraint, rows_at, 16)
AT(TinkerConstraint, prescribed_rate, 24) AT(TinkerConstraint, scale, 32) AT(TinkerConstraint, check, 40)
AT(TinkerConstraint, next_break, 48) AT(TinkerConstraint, distance, 56)
AT(TinkerConstraint, angles, 64) AT(TinkerConstraint, coincident, 68)
AT(TinkerConstraint, turning, 72) AT(TinkerConstraint, friction, 80)
SIZE(TinkerMotion, 40) AT(TinkerMotion, struct_size, 0) AT(TinkerMotion, reserved, 4) AT(TinkerMotion, motion, 8)
AT(TinkerMotion, linear, 16) AT(TinkerMotion, next_break, 24) AT(TinkerMotion, rotation, 32)
SIZE(TinkerPhysics, 64) AT(TinkerPhysics, struct_size, 0) AT(TinkerPhysics, scratch_size, 4)
AT(TinkerPhysics, body, 8) AT(TinkerPhysics, line_law, 16) AT(TinkerPhysics, force_element, 24)
AT(TinkerPhysics, field, 32) AT(TinkerPhysics, constraint, 40) AT(TinkerPhysics, motion, 48)
AT(TinkerPhysics, prepare, 56)

/* plugin.h */
SIZE(TinkerHost, 16) AT(TinkerHost, struct_size, 0) AT(TinkerHost, abi_minor, 4) AT(TinkerHost, service, 8)
SIZE(TinkerLogService, 16) AT(TinkerLogService, struct_size, 0) AT(TinkerLogService, reserved, 4)
AT(TinkerLogService, log, 8)
SIZE(TinkerPlugin, 120) AT(TinkerPlugin, magic, 0) AT(TinkerPlugin, struct_size, 4) AT(TinkerPlugin, abi_minor, 8)
AT(TinkerPlugin, least_host_minor, 12) AT(TinkerPlugin, size_of_double, 16) AT(TinkerPlugin, size_of_index, 20)
AT(TinkerPlugin, id, 24) AT(TinkerPlugin, title, 32) AT(TinkerPlugin, version, 40) AT(TinkerPlugin, licence, 48)
AT(TinkerPlugin, home_page, 56) AT(TinkerPlugin, blocks, 64) AT(TinkerPlugin, integrators, 80)
AT(TinkerPlugin, services, 96) AT(TinkerPlugin, init, 112)

/* render.h */
SIZE(TinkerStyle, 672) AT(TinkerStyle, struct_size, 0) AT(TinkerStyle, state, 4) AT(TinkerStyle, pixel, 8)
AT(TinkerStyle, line_width, 16) AT(TinkerStyle, symbol_size, 24) AT(TinkerStyle, view, 32)
AT(TinkerStyle, transform, 64) AT(TinkerStyle, colours, 112) AT(TinkerStyle, context, 560) AT(TinkerStyle, line, 568)
AT(TinkerStyle, box, 576) AT(TinkerStyle, hatch, 584) AT(TinkerStyle, coil, 592) AT(TinkerStyle, dashpot, 600)
AT(TinkerStyle, bar, 608) AT(TinkerStyle, arrow, 616) AT(TinkerStyle, end_mark, 624) AT(TinkerStyle, circle, 632)
AT(TinkerStyle, text, 640) AT(TinkerStyle, polyline, 648) AT(TinkerStyle, polygon, 656)
AT(TinkerStyle, note, 664)
SIZE(TinkerRender, 24) AT(TinkerRender, struct_size, 0) AT(TinkerRender, layer, 4) AT(TinkerRender, draw, 8)
AT(TinkerRender, bounds, 16)

/* types.h */
SIZE(TinkerSpan, 16) AT(TinkerSpan, data, 0) AT(TinkerSpan, count, 8) AT(TinkerSpan, stride, 12)
SIZE(TinkerDimension, 4) AT(TinkerDimension, mass, 0) AT(TinkerDimension, length, 1) AT(TinkerDimension, time, 2)
AT(TinkerDimension, angle, 3)
SIZE(TinkerInterface, 16) AT(TinkerInterface, id, 0) AT(TinkerInterface, vtable, 8)
SIZE(TinkerPose, 24) AT(TinkerPose, angle, 0) AT(TinkerPose, rate, 8) AT(TinkerPose, acceleration, 16)
SIZE(TinkerPoint, 32) AT(TinkerPoint, x, 0) AT(TinkerPoint, y, 8) AT(TinkerPoint, vx, 16) AT(TinkerPoint, vy, 24)

/* units.h */
SIZE(TinkerUnitChoice, 24) AT(TinkerUnitChoice, id, 0) AT(TinkerUnitChoice, si, 8) AT(TinkerUnitChoice, english, 16)
SIZE(TinkerUnits, 24) AT(TinkerUnits, struct_size, 0) AT(TinkerUnits, reserved, 4) AT(TinkerUnits, choices, 8)
#endif
    /* clang-format on */

    /* What an owner with shorter structs did not declare is not read. */
    static void test_members_beyond_the_declared_size(void)
{
    TinkerInstance instance = {.struct_size = sizeof instance, .symbol_size = 3};
    g_assert_true(TINKER_HAS(TinkerInstance, &instance, symbol_size));
    g_assert_cmpfloat(tinker_instance_symbol_size(&instance), ==, 3);
    instance.struct_size = offsetof(TinkerInstance, symbol_size);
    g_assert_false(TINKER_HAS(TinkerInstance, &instance, symbol_size));
    g_assert_true(TINKER_HAS(TinkerInstance, &instance, time));
    g_assert_cmpfloat(tinker_instance_symbol_size(&instance), !=, 3);
    instance.struct_size++;
    g_assert_false(TINKER_HAS(TinkerInstance, &instance, symbol_size));
}

static void test_spans(void)
{
    static const TinkerInterface interfaces[3] = {{"a", NULL}, {"b", NULL}, {"c", NULL}};
    const TinkerSpan span = TINKER_SPAN(interfaces), none = TINKER_NO_SPAN;
    g_assert_true(span.data == interfaces);
    g_assert_cmpint(span.count, ==, 3);
    g_assert_cmpint(span.stride, ==, sizeof(TinkerInterface));
    g_assert_cmpint(none.count, ==, 0);
}

/* The names of the structs that a header declares; of char *. (transfer full) */
static GPtrArray *structs_of(const char *text)
{
    static const char beginning[] = "\ntypedef struct ";
    GPtrArray *names = g_ptr_array_new_with_free_func(g_free);
    for (const char *at = strstr(text, beginning); at != NULL; at = strstr(at + 1, beginning)) {
        const char *name = at + strlen(beginning);
        g_ptr_array_add(names, g_strndup(name, strcspn(name, " ;")));
    }
    return names;
}

static char *read_source(const char *name)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), name, NULL), *text = NULL;
    g_autoptr(GError) error = NULL;
    g_file_get_contents(path, &text, NULL, &error);
    g_assert_no_error(error);
    return g_steal_pointer(&text);
}

/* No struct escapes the table above. What shapes.h declares stays within a plugin. */
static void test_table_is_complete(void)
{
    static const char *const headers[] = {"block",   "edit",   "graph",  "instance", "integrator",
                                          "physics", "plugin", "render", "types",    "units"};
    g_autofree char *table = read_source("tests/sdk/test-layout.c");
    for (gsize i = 0; i < G_N_ELEMENTS(headers); i++) {
        g_autofree char *name = g_strdup_printf("sdk/include/tinker/%s.h", headers[i]), *text = read_source(name);
        g_autoptr(GPtrArray) names = structs_of(text);
        g_assert_cmpuint(names->len, >, 0);
        for (guint k = 0; k < names->len; k++) {
            g_autofree char *line = g_strdup_printf("SIZE(%s, ", (char *)names->pdata[k]);
            if (strstr(table, line) == NULL) g_error("%s: the size of %s is not in the table", name, line);
        }
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/sdk/members-beyond-the-declared-size", test_members_beyond_the_declared_size);
    g_test_add_func("/sdk/spans", test_spans);
    g_test_add_func("/sdk/table-of-layout-is-complete", test_table_is_complete);
    return g_test_run();
}
