/* What the files of this folder share: how a scene lies in memory. */
#ifndef TINKER_CORE_SCENE_DATA_H
#define TINKER_CORE_SCENE_DATA_H

#include "scene/store/scene.h"

/* All blocks of one class, row by row. Rows are in the order of their ids, which is that of creation. */
typedef struct {
    const TinkerBlockClass *block_class;
    int32_t number; /* of the table in the scene */
    int32_t count, room;
    TinkerBlockId *ids;
    double **columns;                   /* [column][row] */
    guint8 **given;                     /* [property][row]: 1 where it was given */
    char ***texts;                      /* [property][row], NULL for other kinds; NULL where not given */
    TinkerWaveform ***waveforms;        /* likewise */
    TinkerWaveform **default_waveforms; /* [property], NULL for other kinds */
    int32_t *end_offsets;               /* count + 1 entries */
    TinkerSceneEnd *ends;
    int32_t end_room;
    gboolean borrows; /* some default equals another property */
} SceneTable;

/* Where a block's data are. */
#define SCENE_REMOVED     (-1)
#define SCENE_PLACEHOLDER (-2)
typedef struct {
    int32_t table; /* number of its table, or one of the above */
    int32_t row;
    const char *name; /* in the string chunk */
} SceneSlot;

/* A block of a type that nobody provides. */
typedef struct {
    char *type;
    char *text;     /* the JSON object as it was read, on one line */
    char *name;     /* the block's name when it was read */
    gboolean named; /* whether `text` has it */
} ScenePlaceholder;

/* A body that lies on a plate's top, in the place of a position. */
typedef struct {
    TinkerBlockId plate;
    double along; /* m from the middle of the top towards the plate's own +x */
} ScenePlaceOn;

struct _TinkerScene {
    TinkerCatalogue *catalogue;
    TinkerSceneHead head;
    GPtrArray *graphs;
    GPtrArray *instruments;
    GArray *slots;        /* of SceneSlot, by id */
    GArray *order;        /* of TinkerBlockId: the drawing order */
    GPtrArray *tables;    /* of SceneTable * */
    GHashTable *table_of; /* class to SceneTable */
    GStringChunk *names;
    GHashTable *by_name;     /* name to id + 1 */
    GHashTable *next_number; /* title to the smallest number that may be free */
    /* Side tables. Ids are never given again, so entries of removed blocks stay, for undo, and do no harm. */
    GHashTable *placeholders;                       /* id to ScenePlaceholder */
    GHashTable *extras;                             /* id to the block's unknown keys, as members on one line */
    GHashTable *places_on;                          /* id to ScenePlaceOn; see place-on.c */
    GHashTable *end_extras;                         /* id and end (see scene_end_key) to an end's unknown keys */
    GHashTable *sources;                            /* waveform (owned) to the JSON object it was read from */
    char *head_extras, *canvas_extras, *run_extras; /* unknown keys; may be NULL */
};

static inline SceneSlot *scene_slot(const TinkerScene *scene, TinkerBlockId block)
{
    return &g_array_index(scene->slots, SceneSlot, block);
}

static inline SceneTable *scene_table_of(const TinkerScene *scene, TinkerBlockId block)
{
    int32_t number = scene_slot(scene, block)->table;
    return number < 0 ? NULL : g_ptr_array_index(scene->tables, number);
}

/* Head --------------------------------------------------------------------------------------------------------- */

void scene_head_init(TinkerSceneHead *head);
void scene_head_clear(TinkerSceneHead *head);
TinkerSceneHead *scene_head_copy(const TinkerSceneHead *head);
void scene_head_free(TinkerSceneHead *head);
/* What a head may not hold, in words ("run: duration must be ..."), or NULL. (transfer full) */
char *scene_head_fault(const TinkerSceneHead *head);

/* A number of the head, described as a property is, and where it goes. */
typedef struct {
    const char *part; /* "canvas" or "run": the object that it stands in */
    TinkerPropertyType type;
    gsize offset;         /* in TinkerSceneHead */
    gboolean may_be_none; /* which is 0 there, and no member in the file */
} SceneHeadNumber;
extern const SceneHeadNumber scene_head_numbers[]; /* ends with an entry without part */
extern const char *const scene_contacts[];         /* what "contacts" may be; ends with NULL */

/* Graphs ------------------------------------------------------------------------------------------------------- */

void scene_curve_free(TinkerSceneCurve *curve);
/* What a graph is called in messages: by its first curve. */
const char *scene_graph_name(const TinkerSceneGraph *graph);
/* What is wrong with a graph in this scene, with one of its curves, with its size, with a range; or NULL. (transfer
 * full) */
char *scene_graph_fault(const TinkerScene *scene, const TinkerSceneGraph *graph);
char *scene_curve_fault(const TinkerScene *scene, const TinkerSceneGraph *graph, const TinkerSceneCurve *curve);
char *scene_graph_size_fault(const double size[2]);
char *scene_graph_range_fault(const TinkerSceneGraph *graph, int axis);
/* That the block, or the scene, does not have the quantity, with a suggestion, or NULL. (transfer full) */
char *scene_quantity_fault(const TinkerScene *scene, TinkerBlockId block, const char *quantity);
/* Of all curves of a graph. (transfer full) */
GArray *scene_graph_blocks(const TinkerScene *scene, const TinkerSceneGraph *graph);
/* The places of graphs with curves of these blocks in the scene's list of them, last first; of guint. (transfer full)
 */
GArray *scene_graphs_of(const TinkerScene *scene, GHashTable *blocks);
/* The graph without the curves of these blocks. (transfer full) */
TinkerSceneGraph *scene_graph_without(const TinkerScene *scene, const TinkerSceneGraph *graph, GHashTable *blocks);
/* Graphs name their blocks, so they follow them. */
/* Whether it is over time, or of frequencies: of samples of any curve, and not against a quantity. */
gboolean scene_graph_is_of_samples(const TinkerSceneGraph *graph);
void scene_graph_rename(TinkerSceneGraph *graph, const char *from, const char *to);

/* Instruments -------------------------------------------------------------------------------------------------- */

extern const char *const scene_instrument_kinds[]; /* by TinkerInstrumentKind; ends with NULL */
/* (transfer full) */
GPtrArray *scene_instruments_copy(const GPtrArray *instruments);
/* What is wrong with one in this scene, or NULL. (transfer full) */
char *scene_instrument_fault(const TinkerScene *scene, const TinkerSceneInstrument *instrument);
gboolean scene_instrument_is_of(const TinkerScene *scene, const TinkerSceneInstrument *instrument, GHashTable *blocks);
void scene_instrument_rename(TinkerSceneInstrument *instrument, const char *from, const char *to);

/* Tables ------------------------------------------------------------------------------------------------------- */

/* The table of a class, made where there is none yet. (transfer none) */
SceneTable *scene_table_for(TinkerScene *scene, const TinkerBlockClass *block_class);
void scene_table_free(SceneTable *table);

/* Opens a row with the defaults and detached ends behind all others. */
void scene_table_append(TinkerScene *scene, SceneTable *table, TinkerBlockId id, int32_t end_count);

typedef struct {
    TinkerBlockId id;
    int32_t end_count;
} SceneNewRow;
/* Opens rows likewise among the others, in the order of their ids, in which they are given. */
void scene_table_insert(TinkerScene *scene, SceneTable *table, const SceneNewRow *rows, int32_t count);
/* Removes the rows of these blocks, as many as are in the table. */
void scene_table_remove(TinkerScene *scene, SceneTable *table, GHashTable *blocks);

/* Number of ends, and the first of them, of a row. */
static inline int32_t scene_table_end_count(const SceneTable *table, int32_t row)
{
    return table->end_offsets[row + 1] - table->end_offsets[row];
}

static inline TinkerSceneEnd *scene_table_ends(const SceneTable *table, int32_t row)
{
    return table->ends == NULL ? NULL : table->ends + table->end_offsets[row];
}

/* Puts a property's default into its columns; what equals another property is left to scene_table_resolve. */
void scene_table_set_default(SceneTable *table, int32_t row, int32_t property);

/* Fills in the defaults that equal another property. */
void scene_table_resolve(SceneTable *table, int32_t row);

/* Blocks ------------------------------------------------------------------------------------------------------- */

/* A set of blocks, by id as GINT_TO_POINTER. (transfer full) */
GHashTable *scene_block_set(const TinkerBlockId *blocks, gsize count);

/* Adds a block at the end of the drawing order without a name; of a class, or (NULL) a placeholder, which takes
 * `placeholder`. */
TinkerBlockId scene_append(TinkerScene *scene, const TinkerBlockClass *block_class, int32_t end_count,
                           ScenePlaceholder *placeholder);
ScenePlaceholder *scene_placeholder_copy(const ScenePlaceholder *placeholder);
void scene_placeholder_free(ScenePlaceholder *placeholder);
/* Names in the ends of a placeholder follow: old name to new name. Answers whether there was one. */
gboolean scene_placeholder_rename_ends(ScenePlaceholder *placeholder, GHashTable *names);
void scene_placeholders_follow(TinkerScene *scene, const char *old_name, const char *new_name);
/* The placeholders in the scene whose ends name one of these blocks, but none of the blocks; of TinkerBlockId.
 * (transfer full) */
GArray *scene_placeholders_on(const TinkerScene *scene, GHashTable *blocks);
/* Their ends on the blocks become detached ones at the same places, as those of other blocks do where these are
 * removed. */
void scene_placeholders_detach(TinkerScene *scene, GHashTable *blocks);

/* The place of a block in the drawing order, 0 for the one that is drawn first; and moving it to another. */
int32_t scene_order_of(const TinkerScene *scene, TinkerBlockId block);
void scene_move_in_order(TinkerScene *scene, TinkerBlockId block, int32_t place);

/* What is wrong with a name, or NULL. (transfer full) */
char *scene_name_fault(const TinkerScene *scene, const char *name);
/* Gives a block its name without asking; graphs that name the block follow. */
void scene_assign_name(TinkerScene *scene, TinkerBlockId block, const char *name);
/* Type's title and the smallest free number. */
void scene_assign_default_name(TinkerScene *scene, TinkerBlockId block);
void scene_forget_name(TinkerScene *scene, TinkerBlockId block);

/* Properties --------------------------------------------------------------------------------------------------- */

/* What is wrong with a property's value ("mass must be greater than 0 kg (it is -1 kg)"), or NULL. `typed` has the text
 * that each of its numbers was given as ("-3 lb"), NULL for a plain number; it may be NULL. (transfer full) */
char *scene_value_fault(const TinkerPropertyType *property, const double *values, const char *const *typed);
/* Stores values that have been checked; the caller resolves. */
void scene_store(SceneTable *table, int32_t row, int32_t property, const double *values);
/* What is wrong with a row as a whole (dynamic above static friction), or NULL. (transfer full) */
char *scene_row_fault(const SceneTable *table, int32_t row);
void scene_store_text(SceneTable *table, int32_t row, int32_t property, const char *text);
void scene_store_waveform(SceneTable *table, int32_t row, int32_t property, TinkerWaveform *waveform);

/* Ends --------------------------------------------------------------------------------------------------------- */

gint64 *scene_end_key(TinkerBlockId block, int32_t end);
/* What is wrong with attaching an end like this ("end 2 is on ..."), or NULL. (transfer full) */
char *scene_end_fault(const TinkerScene *scene, TinkerBlockId block, int32_t end, TinkerSceneEnd to);
/* Where an end is on the canvas, by the blocks' own position and orientation. */
void scene_end_place(const TinkerScene *scene, TinkerSceneEnd end, double place[2]);
/* The other blocks that have an end on one of these; of TinkerBlockId. (transfer full) */
GArray *scene_attached_to(const TinkerScene *scene, GHashTable *blocks);
/* Other blocks need these no more: ends on them, placeholders' too, become detached ones at the same places, and what
 * lies on them stays where it is. */
void scene_detach(TinkerScene *scene, GHashTable *blocks);

/* Places on tops ----------------------------------------------------------------------------------------------- */

/* How a body lies; NULL where it is by its position. Set with NULL: from now on it is. Nothing moves before
 * scene_settle. */
const ScenePlaceOn *scene_place_on(const TinkerScene *scene, TinkerBlockId block);
void scene_set_place_on(TinkerScene *scene, TinkerBlockId block, const ScenePlaceOn *on);
/* What is wrong with lying on that block, or NULL. (transfer full) */
char *scene_place_on_fault(const TinkerScene *scene, TinkerBlockId block, TinkerBlockId plate);
/* The other blocks that lie on one of these plates, of TinkerBlockId. (transfer full) */
GArray *scene_placed_on(const TinkerScene *scene, GHashTable *plates);
/* The place of a body that lies on a top becomes its given position and orientation. */
void scene_fix_place(TinkerScene *scene, TinkerBlockId block);
/* Works out the places of all bodies that lie on tops: after every change of the scene. Costs nothing where there are
 * none. */
void scene_settle(TinkerScene *scene);
/* Works out the places of bodies that lie on tops after a change of one block: costs nothing where that has no top,
 * moves none and lies on none. */
void scene_settle_after(TinkerScene *scene, TinkerBlockId block);

/* Snapshots ---------------------------------------------------------------------------------------------------- */

/* The values, ends and name of one block, so that it can be as it was. */
typedef struct _SceneSnapshot SceneSnapshot;
SceneSnapshot *scene_snapshot_take(const TinkerScene *scene, TinkerBlockId block);
void scene_snapshot_free(SceneSnapshot *snapshot);
TinkerBlockId scene_snapshot_block(const SceneSnapshot *snapshot);
/* The number of its table, or SCENE_PLACEHOLDER. */
int32_t scene_snapshot_table(const SceneSnapshot *snapshot);
int32_t scene_snapshot_end_count(const SceneSnapshot *snapshot);
/* Whether two snapshots of one block have different names. */
gboolean scene_snapshot_renames(const SceneSnapshot *before, const SceneSnapshot *after);
/* Makes the block, which is there, what it was; what lies on tops is settled by the caller. */
void scene_snapshot_restore(TinkerScene *scene, const SceneSnapshot *snapshot);
/* Gives a block all values and ends of one of the same class in another scene; ends keep the ids of that scene. */
void scene_copy_row(const TinkerScene *from, TinkerBlockId block, TinkerScene *to, TinkerBlockId copy);

/* Everything about several blocks, so that they can be taken out and brought back together: their snapshots, places in
 * the drawing order, and graphs. Each of these takes a pass over the scene, however many they are. */
typedef struct _SceneBlocks SceneBlocks;
SceneBlocks *scene_blocks_keep(const TinkerScene *scene, const TinkerBlockId *blocks, gsize count);
void scene_blocks_free(SceneBlocks *blocks);
/* Takes them out with their graphs, but leaves the ends on them to the caller (scene_detach). */
void scene_blocks_take_out(TinkerScene *scene, const SceneBlocks *blocks);
/* They come back under their ids, at their places in the drawing order. */
void scene_blocks_bring_back(TinkerScene *scene, const SceneBlocks *blocks);
/* What the second of these does, for blocks that nobody keeps. */
void scene_take_out(TinkerScene *scene, GHashTable *blocks);

#endif
