/* What the files of the property list share. */
#ifndef TINKER_GUI_PROPERTY_ROWS_H
#define TINKER_GUI_PROPERTY_ROWS_H

#include "gui/property/property-list.h"

#define PROPERTY_DIGITS 7 /* significant ones, of limits and of numbers without a unit */

/* A list in the making: rows are added for these blocks, which are of one class. */
typedef struct {
    TinkerDocument *document;
    TinkerPlayer *player;
    TinkerScene *scene;
    TinkerUnitSystem system;
    gboolean trims; /* numbers have no zeros at the end of their decimals */
    GPtrArray *rows;
    const TinkerBlockId *blocks;
    int count;
    const TinkerBlockClass *block_class; /* NULL of a placeholder, and of the scene */
    const char *group;                   /* instead of that of the property; NULL: its own */
} PropertyBuilder;

/* A new row at the end of the list, for the blocks of the builder. Texts are copied. (transfer none) */
TinkerPropertyRow *property_builder_add(PropertyBuilder *builder, TinkerRowKind kind, const char *group,
                                        const char *title, const char *description);
void property_row_take_text(TinkerPropertyRow *row, char *text);
/* Sorts it by another text than its title, and by its component within that. */
void property_row_sort_by(TinkerPropertyRow *row, const char *text);

/* The rows of blocks; property-rows.c. */
void property_rows_add_name(PropertyBuilder *builder);
void property_rows_add_property(PropertyBuilder *builder, int32_t property);
/* What quantities are now, where there is a record; property-rows-live.c. */
void property_rows_add_readings(PropertyBuilder *builder);
/* What it is connected to, and where on that; property-rows-ends.c. */
void property_rows_add_ends(PropertyBuilder *builder);
/* Those of blocks attached to the one of the builder, and of types that could be; property-rows-attached.c. */
void property_rows_add_attached(PropertyBuilder *builder);
/* Waveforms; property-rows-waveform.c. `data` of the row is NULL, or the class whose block has first to be attached. */
void property_rows_add_waveform(PropertyBuilder *builder, int32_t property);
/* A waveform that there is no block for yet: that of a class to be attached. */
void property_rows_add_missing_waveform(PropertyBuilder *builder, const TinkerBlockClass *block_class,
                                        int32_t property);
/* Sets the waveform of a row as one step, where need be in a block that is attached for it. */
gboolean property_set_waveform(TinkerDocument *document, const TinkerPropertyRow *row, TinkerWaveform *waveform,
                               GError **error);
/* How the table of a waveform is read, where all blocks have the same; property-rows-table.c. */
void property_rows_add_table(PropertyBuilder *builder, const TinkerPropertyType *type, int32_t property);
/* Whether a property scales, turns or shifts waveforms of the block that have no use for it as they are. */
gboolean property_plays_no_part(const TinkerScene *scene, TinkerBlockId block, int32_t property);
/* The heading that rows of a property stand under. */
const char *property_group_of(const PropertyBuilder *builder, const TinkerPropertyType *type);
/* The title of the row that chooses the law of impact; property-rows-scene.c. Borrowed. */
const char *property_law_of_impact(void);
/* Those of the scene; property-rows-scene.c. */
void property_rows_add_scene(PropertyBuilder *builder);

/* How rows of what a descriptor declares are set; property-set.c. An offset is that from the local origin, which stays.
 * A law that cannot be read is not taken; its numbers may still be to come. */
gboolean property_set_number(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error);
gboolean property_set_offset(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error);
gboolean property_choose_number(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error);
gboolean property_set_text(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error);
gboolean property_set_law(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error);
/* "greater than 0 kg", "from 0 to 1"; NULL where anything goes. (transfer full) */
char *property_range_text(const TinkerPropertyType *type, const char *unit);

/* Changes one block inside a step; `value` is what property_edit_all was given. */
typedef gboolean (*PropertyEdit)(TinkerHistory *history, const TinkerPropertyRow *row, TinkerBlockId block,
                                 gconstpointer value, GError **error);
/* Changes all blocks of a row as one step; where one refuses, none is changed. */
gboolean property_edit_all(TinkerDocument *document, const TinkerPropertyRow *row, PropertyEdit edit,
                           gconstpointer value, GError **error);

/* Reads a number in any unit; without one it is in `unit`. The error is a sentence. */
gboolean property_parse_number(const char *text, TinkerDimension dimension, const char *unit, double *si,
                               GError **error);
/* Makes a message of core/ a sentence: without "column N: " and "Mass 0: " before it, ids as titles, a capital and a
 * full stop. `block_class` may be NULL. Takes the error. */
void property_fail(GError **error, GError *cause, const char *prefix, const TinkerBlockClass *block_class);
gboolean property_refuse(GError **error, const char *format, ...) G_GNUC_PRINTF(2, 3);

#endif
