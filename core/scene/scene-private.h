/* What the files of this folder share: how a scene lies in memory. */
#ifndef TINKER_CORE_SCENE_PRIVATE_H
#define TINKER_CORE_SCENE_PRIVATE_H

#include "scene/scene.h"

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

struct _TinkerScene {
    TinkerCatalogue *catalogue;
    TinkerSceneHead head;
    GPtrArray *graphs;
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
    gsize offset; /* in TinkerSceneHead */
} SceneHeadNumber;
extern const SceneHeadNumber scene_head_numbers[]; /* ends with an entry without part */
extern const char *const scene_contacts[];         /* what "contacts" may be; ends with NULL */

/* Graphs ------------------------------------------------------------------------------------------------------- */

TinkerSceneGraph *scene_graph_copy(const TinkerSceneGraph *graph);
void scene_graph_free(TinkerSceneGraph *graph);
/* What is wrong with a graph in this scene, or NULL. (transfer full) */
char *scene_graph_fault(const TinkerScene *scene, const TinkerSceneGraph *graph);
char *scene_graph_size_fault(const double size[2]);
/* That blocks of this class do not have the quantity, with a suggestion, or NULL. (transfer full) */
char *scene_quantity_fault(const TinkerBlockClass *block_class, const char *quantity);

/* Tables ------------------------------------------------------------------------------------------------------- */

/* The table of a class, made where there is none yet. (transfer none) */
SceneTable *scene_table_for(TinkerScene *scene, const TinkerBlockClass *block_class);
void scene_table_free(SceneTable *table);

/* Opens a row with the defaults and detached ends, and sets the slots of it and of those behind it. */
void scene_table_insert(TinkerScene *scene, SceneTable *table, int32_t row, TinkerBlockId id, int32_t end_count);
void scene_table_remove(TinkerScene *scene, SceneTable *table, int32_t row);

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

/* Adds a block at the end of the drawing order without a name; of a class, or (NULL) a placeholder, which takes
 * `placeholder`. */
TinkerBlockId scene_append(TinkerScene *scene, const TinkerBlockClass *block_class, int32_t end_count,
                           ScenePlaceholder *placeholder);
ScenePlaceholder *scene_placeholder_copy(const ScenePlaceholder *placeholder);
void scene_placeholder_free(ScenePlaceholder *placeholder);
/* Names in the ends of a placeholder follow: old name to new name. Answers whether there was one. */
gboolean scene_placeholder_rename_ends(ScenePlaceholder *placeholder, GHashTable *names);
void scene_placeholders_follow(TinkerScene *scene, const char *old_name, const char *new_name);
/* The placeholders in the scene whose ends name a block; of TinkerBlockId. (transfer full) */
GArray *scene_placeholders_on(const TinkerScene *scene, TinkerBlockId block);
/* Their ends on the block become detached ones at the same places, as those of other blocks do where it is removed. */
void scene_placeholders_detach(TinkerScene *scene, TinkerBlockId block);

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

/* The places of a block's graphs in the scene's list of them, last first. (transfer full) */
GArray *scene_graphs_of(const TinkerScene *scene, TinkerBlockId block);

/* Properties --------------------------------------------------------------------------------------------------- */

/* What is wrong with a property's value ("mass must be greater than 0 kg (it is -1 kg)"), or NULL. (transfer full) */
char *scene_value_fault(const TinkerPropertyType *property, const double *values);
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
/* The blocks that have an end on this one; of TinkerBlockId. (transfer full) */
GArray *scene_attached_to(const TinkerScene *scene, TinkerBlockId block);

/* Snapshots ---------------------------------------------------------------------------------------------------- */

/* Everything about one block, so that it can be brought back. */
typedef struct _SceneSnapshot SceneSnapshot;
SceneSnapshot *scene_snapshot_take(const TinkerScene *scene, TinkerBlockId block);
void scene_snapshot_free(SceneSnapshot *snapshot);
/* Whether two snapshots of one block have different names. */
gboolean scene_snapshot_renames(const SceneSnapshot *before, const SceneSnapshot *after);
/* Makes the block what it was; one that was removed comes back under its id, at its place in the drawing order. */
void scene_snapshot_restore(TinkerScene *scene, const SceneSnapshot *snapshot);
/* Gives a block all values and ends of one of the same class in another scene; ends keep the ids of that scene. */
void scene_copy_row(const TinkerScene *from, TinkerBlockId block, TinkerScene *to, TinkerBlockId copy);
/* Takes a block out as tinker_scene_remove_block does, but leaves the ends on it to the caller. */
void scene_take_out(TinkerScene *scene, TinkerBlockId block);

#endif
