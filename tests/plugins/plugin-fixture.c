/* Opening the built libraries and making batches; see the header. */
#include "plugin-fixture.h"

#include <dlfcn.h>
#include <math.h>
#include <string.h>

const char *const block_names[] = {"mass",           "support", "spring", "damper", "rod",  "motor",
                                   "support-motion", "gravity", "wind",   "marker", "rope", NULL};

char *plugin_path(const char *block_name)
{
    const char *folder = g_getenv("TINKER_TEST_PLUGINS");
    g_assert_nonnull(folder);
    return g_strdup_printf("%s/tinker-%s.so", folder, block_name);
}

const TinkerPlugin *plugin_open(const char *block_name)
{
    g_autofree char *path = plugin_path(block_name);
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == NULL) g_error("%s", dlerror());
    const TinkerPlugin *(*entry)(void);
    void *symbol = dlsym(library, TINKER_ENTRY_SYMBOL);
    g_assert_nonnull(symbol);
    memcpy(&entry, &symbol, sizeof entry);
    const TinkerPlugin *plugin = entry();
    g_assert_true(plugin == entry());
    dlclose(library);
    return plugin;
}

static const void *span_item(const TinkerSpan *span, int32_t number)
{
    g_assert_cmpint(number, <, span->count);
    return (const char *)span->data + (size_t)number * (size_t)span->stride;
}

const TinkerBlockType *block_open(const char *block_name)
{
    const TinkerPlugin *plugin = plugin_open(block_name);
    g_assert_cmpint(plugin->blocks.count, ==, 1);
    return span_item(&plugin->blocks, 0);
}

const TinkerIntegrator *integrator_open(const char *name)
{
    const TinkerPlugin *plugin = plugin_open(name);
    g_assert_cmpint(plugin->integrators.count, ==, 1);
    return span_item(&plugin->integrators, 0);
}

const void *block_interface(const TinkerBlockType *block, const char *id)
{
    for (int32_t i = 0; i < block->interfaces.count; i++) {
        const TinkerInterface *interface = span_item(&block->interfaces, i);
        if (strcmp(interface->id, id) == 0) return interface->vtable;
    }
    return NULL;
}

const TinkerPhysics *block_physics(const TinkerBlockType *block)
{
    const TinkerPhysics *physics = block_interface(block, TINKER_PHYSICS_INTERFACE);
    g_assert_nonnull(physics);
    return physics;
}

const TinkerPropertyType *block_property(const TinkerBlockType *block, int32_t number)
{
    return span_item(&block->properties, number);
}

const TinkerQuantityType *block_quantity(const TinkerBlockType *block, int32_t number)
{
    return span_item(&block->quantities, number);
}

int32_t kind_columns(int32_t kind)
{
    return kind == TINKER_KIND_TEXT ? 0 : kind == TINKER_KIND_VECTOR ? 2 : kind == TINKER_KIND_WAVEFORM ? 3 : 1;
}

/* Columns of the properties before `number`. */
static int32_t columns_before(const TinkerBlockType *block, int32_t number)
{
    int32_t columns = 0;
    for (int32_t i = 0; i < number; i++) {
        columns += kind_columns(block_property(block, i)->kind);
    }
    return columns;
}

int32_t block_columns(const TinkerBlockType *block)
{
    return columns_before(block, block->properties.count);
}

int32_t block_column(const TinkerBlockType *block, const char *property)
{
    for (int32_t i = 0; i < block->properties.count; i++) {
        if (strcmp(block_property(block, i)->id, property) == 0) return columns_before(block, i);
    }
    g_error("%s has no property %s", block->id, property);
}

int32_t block_quantity_number(const TinkerBlockType *block, const char *quantity)
{
    for (int32_t i = 0; i < block->quantities.count; i++) {
        if (strcmp(block_quantity(block, i)->id, quantity) == 0) return i;
    }
    g_error("%s has no quantity %s", block->id, quantity);
}

BlockBatch *block_batch_new(const TinkerBlockType *block, int32_t count)
{
    const int32_t columns = block_columns(block);
    BlockBatch *batch = g_new0(BlockBatch, 1);
    *batch =
        (BlockBatch){block, g_new0(double *, columns + 1), g_new0(const double *, columns), count, block->most_ends};
    for (int32_t i = 0; i < block->properties.count; i++) {
        const TinkerPropertyType *property = block_property(block, i);
        const int32_t first = columns_before(block, i);
        for (int32_t offset = 0; offset < kind_columns(property->kind); offset++) {
            batch->columns[first + offset] = g_new0(double, count);
            for (int32_t k = 0; k < count && property->kind != TINKER_KIND_WAVEFORM; k++) {
                batch->columns[first + offset][k] = property->default_value[offset];
            }
        }
    }
    return batch;
}

void block_batch_free(BlockBatch *batch)
{
    for (int32_t column = 0; column < block_columns(batch->block); column++) {
        g_free(batch->columns[column]);
    }
    g_free(batch->columns);
    g_free(batch->view_columns);
    g_free(batch);
}

void block_batch_set(BlockBatch *batch, int32_t instance, const char *property, int32_t offset, double value)
{
    batch->columns[block_column(batch->block, property) + offset][instance] = value;
}

TinkerBatch block_batch_view(BlockBatch *batch, int32_t first, int32_t count)
{
    for (int32_t column = 0; column < block_columns(batch->block); column++) {
        batch->view_columns[column] = batch->columns[column] + first;
    }
    return (TinkerBatch){.struct_size = sizeof(TinkerBatch),
                         .first = first,
                         .count = count,
                         .ends = batch->ends,
                         .columns = batch->view_columns,
                         .failed_instance = -1};
}

double rescale_factor(TinkerDimension dimension)
{
    return ldexp(1.0, 2 * dimension.mass + 3 * dimension.length - dimension.time);
}

void block_batch_rescale(BlockBatch *batch)
{
    for (int32_t i = 0; i < batch->block->properties.count; i++) {
        const TinkerPropertyType *property = block_property(batch->block, i);
        for (int32_t offset = 0; offset < kind_columns(property->kind); offset++) {
            TinkerDimension dimension = property->dimension;
            if (property->kind == TINKER_KIND_WAVEFORM) dimension.time = (int8_t)(dimension.time - offset);
            double *column = batch->columns[columns_before(batch->block, i) + offset];
            for (int32_t k = 0; k < batch->count; k++) {
                column[k] *= rescale_factor(dimension);
            }
        }
    }
}

void points_rescale(TinkerPoint *points, int count)
{
    const double length = rescale_factor((TinkerDimension)TINKER_DIMENSION_LENGTH);
    const double velocity = rescale_factor((TinkerDimension)TINKER_DIMENSION_VELOCITY);
    for (int k = 0; k < count; k++) {
        points[k].x *= length;
        points[k].y *= length;
        points[k].vx *= velocity;
        points[k].vy *= velocity;
    }
}

double block_quantity_value(BlockBatch *batch, const TinkerGraphInput *input, const char *quantity)
{
    const TinkerGraph *graph = block_interface(batch->block, TINKER_GRAPH_INTERFACE);
    TinkerBatch view = block_batch_view(batch, 0, 1);
    double value = NAN;
    g_assert_cmpint(graph->values(&view, input, block_quantity_number(batch->block, quantity), &value), ==, TINKER_OK);
    return value;
}

void assert_close(double a, double b, double relative)
{
    const double scale = fmax(fabs(a), fabs(b));
    if (!(fabs(a - b) <= relative * scale)) g_error("%.17g is not %.17g within %g", a, b, relative);
}

double random_value(void)
{
    const double size = pow(10.0, g_test_rand_double_range(-3, 3));
    return g_test_rand_int_range(0, 2) ? size : -size;
}
