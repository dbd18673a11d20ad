/* What the tests of the block plugins share: opening the built libraries as a host would, and batches made from a
 * block's own declaration. */
#ifndef TINKER_TESTS_PLUGIN_FIXTURE_H
#define TINKER_TESTS_PLUGIN_FIXTURE_H

#include <glib.h>

#include <tinker/sdk.h>

/* All, ended by NULL. */
extern const char *const block_names[];

/* Path of the library of a block, in the folder that the environment variable TINKER_TEST_PLUGINS names.
 * (transfer full) */
char *plugin_path(const char *block_name);

/* The plugin of a block, opened with immediate, local binding; stays open. */
const TinkerPlugin *plugin_open(const char *block_name);

/* Its one block type. */
const TinkerBlockType *block_open(const char *block_name);

/* The one integrator of a plugin of that name. */
const TinkerIntegrator *integrator_open(const char *name);

/* An interface of a block type, or NULL. */
const void *block_interface(const TinkerBlockType *block, const char *id);
const TinkerPhysics *block_physics(const TinkerBlockType *block);

const TinkerPropertyType *block_property(const TinkerBlockType *block, int32_t number);
const TinkerQuantityType *block_quantity(const TinkerBlockType *block, int32_t number);

/* How many columns a kind takes; of a block all columns; the first column of a property, which must exist. */
int32_t kind_columns(int32_t kind);
int32_t block_columns(const TinkerBlockType *block);
int32_t block_column(const TinkerBlockType *block, const char *property);

/* Number of a quantity, which must exist. */
int32_t block_quantity_number(const TinkerBlockType *block, const char *quantity);

/* `count` instances, every column at its declared default (waveforms at 0). */
typedef struct {
    const TinkerBlockType *block;
    double **columns;
    const double **view_columns;
    int32_t count;
    int32_t ends;
} BlockBatch;

BlockBatch *block_batch_new(const TinkerBlockType *block, int32_t count);
void block_batch_free(BlockBatch *batch);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(BlockBatch, block_batch_free)

/* Sets component `offset` of a property of one instance. */
void block_batch_set(BlockBatch *batch, int32_t instance, const char *property, int32_t offset, double value);

/* Instances first to first + count - 1 as a plugin sees them. Valid until the next view of the same batch. */
TinkerBatch block_batch_view(BlockBatch *batch, int32_t first, int32_t count);

/* Units in which kg, m and s count 4, 8 and 1/2 (powers of two, so that rescaling is exact): the factor of a dimension,
 * and all columns of a batch converted by their declared dimensions. */
double rescale_factor(TinkerDimension dimension);
void block_batch_rescale(BlockBatch *batch);
void points_rescale(TinkerPoint *points, int count);

/* One value of a quantity of the first instance. */
double block_quantity_value(BlockBatch *batch, const TinkerGraphInput *input, const char *quantity);

/* |a - b| at most `relative` of the larger. */
void assert_close(double a, double b, double relative);

/* Random numbers of both signs and of any size between 1e-3 and 1e3. */
double random_value(void);

#endif
