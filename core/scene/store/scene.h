/* A scene: what the user built. Blocks of one type lie in one table, a column of doubles per property component.
 *
 * A block is known by its id, a number that stays the same as long as the scene lives and is never given again. All
 * values are SI. What a scene holds is always valid: setters refuse what the block's descriptor does not allow.
 */
#ifndef TINKER_CORE_SCENE_H
#define TINKER_CORE_SCENE_H

#include <glib.h>

#include "plugin/catalogue/catalogue.h"
#include "units/quantity/units.h"
#include "units/waveform/waveform.h"

typedef int32_t TinkerBlockId;
#define TINKER_NO_BLOCK (-1)

typedef enum {
    TINKER_SCENE_ERROR_NAME,   /* taken, or not a name */
    TINKER_SCENE_ERROR_VALUE,  /* out of range, wrong kind */
    TINKER_SCENE_ERROR_END,    /* wrong number of ends, or an end that the type does not accept */
    TINKER_SCENE_ERROR_FILE,   /* could not be read or written */
    TINKER_SCENE_ERROR_SYNTAX, /* not a scene */
    TINKER_SCENE_ERROR_TYPE,   /* a type that nobody provides */
    TINKER_SCENE_ERROR_METHOD, /* a method that nobody provides */
} TinkerSceneError;
#define TINKER_SCENE_ERROR (tinker_scene_error_quark())
GQuark tinker_scene_error_quark(void);

/* What `impact_law` may be, in the order of TinkerImpactLaw; ends with NULL. */
extern const char *const tinker_scene_impact_laws[];

/* How a scene is to be run. */
typedef struct {
    double duration;  /* s */
    double interval;  /* s between samples */
    char *method;     /* owned */
    double step;      /* s, of fixed-step methods */
    double tolerance; /* of adaptive ones */
    double accuracy;  /* wanted of the whole run, in place of step and tolerance: the largest error estimate; 0: none */
    char *contacts;   /* "events" or "impulse"; owned */
    char *impact_law; /* one of tinker_scene_impact_laws; owned */
    double spectral_radius;
    char *until; /* conditions of which the first that holds ends it (conditions.h); "": none; owned */
} TinkerRunSettings;

/* One end of a connector, force or motion. */
typedef struct {
    TinkerBlockId block; /* TINKER_NO_BLOCK: detached, and (x, y) is a place on the canvas */
    double x, y;         /* a point fixed to the block, in its own axes, from its centre */
} TinkerSceneEnd;

/* One curve of a graph: a quantity of a block or of the scene, or an expression of quantities, or the column of a table
 * in a file. Strings are owned. */
typedef struct {
    char *block;      /* name, or "Scene"; NULL where it is no quantity */
    char *quantity;   /* likewise its id */
    char *expression; /* see scene-expression.h */
    char *table;      /* relative to the scene's folder */
    int column;       /* of the table, from 0: the values, */
    int time_column;  /* and the times, in another one */
    char *title;      /* may be NULL */
    char *unit;       /* of an expression or a table, as read by people; may be NULL */
    int axis;         /* 1: left, 2: right */
    char *extras;     /* keys that the reader did not know, as JSON members; may be NULL */
} TinkerSceneCurve;

typedef struct {
    GPtrArray *curves; /* of TinkerSceneCurve, one at least */
    char *against;     /* "time", "frequency" (a spectrum), or a quantity of each curve's own block */
    char *title;       /* may be NULL */
    double place[2], size[2];
    gboolean has_place, has_size;
    gboolean logarithmic[2]; /* x, y */
    gboolean has_range[2];
    double range[2][2]; /* of x and of y, in SI */
    char *extras;       /* keys that the reader did not know, as JSON members; owned, may be NULL */
} TinkerSceneGraph;

/* What stands on the canvas beside the scene: controls set a number of a block, meters show a quantity. */
typedef enum {
    TINKER_INSTRUMENT_SLIDER,
    TINKER_INSTRUMENT_KNOB,
    TINKER_INSTRUMENT_SWITCH,
    TINKER_INSTRUMENT_NUMBER, /* the first of the meters */
    TINKER_INSTRUMENT_DIAL,
    TINKER_INSTRUMENT_BAR,
} TinkerInstrumentKind;

typedef struct {
    TinkerInstrumentKind kind;
    char *block;           /* name, or of a meter "Scene"; owned */
    char *of;              /* of a control a property, or "velocity.x" of a vector; of a meter a quantity; owned */
    double from, to, step; /* of a control, in SI; a switch is off at `from`; step 0: any value */
    gboolean has_place;
    double place[2];    /* of its upper left corner */
    gboolean makes_way; /* nobody chose the place, and no run was known: it keeps clear of where blocks go */
    char *extras;       /* keys that the reader did not know, as JSON members; owned, may be NULL */
} TinkerSceneInstrument;

static inline gboolean tinker_instrument_controls(const TinkerSceneInstrument *instrument)
{
    return instrument->kind < TINKER_INSTRUMENT_NUMBER;
}

typedef struct {
    char *title, *description, *author; /* never NULL */
    TinkerUnitSystem units;
    double canvas_width, canvas_grid;
    gboolean canvas_snap;
    TinkerRunSettings run;
} TinkerSceneHead;

typedef struct _TinkerScene TinkerScene;

/* An empty scene with the defaults of the format. The catalogue is borrowed and outlives it. (transfer full) */
TinkerScene *tinker_scene_new(TinkerCatalogue *catalogue);
/* A copy in memory of its own: ids, names, order, placeholders, graphs, head. It may be used by another thread
 * than the original, also while that is edited. (transfer full) */
TinkerScene *tinker_scene_copy(const TinkerScene *scene);
void tinker_scene_free(TinkerScene *scene);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerScene, tinker_scene_free)

TinkerCatalogue *tinker_scene_catalogue(const TinkerScene *scene);

/* Title, units, canvas, run settings; may be written to directly. Strings are g_strdup'ed and owned by the scene. */
TinkerSceneHead *tinker_scene_head(TinkerScene *scene);

/* Of TinkerSceneGraph *; may be changed. (transfer none) */
GPtrArray *tinker_scene_graphs(TinkerScene *scene);

/* An empty graph over time; a curve of a block's quantity, added to it; a copy. (transfer full; none; full) */
TinkerSceneGraph *tinker_scene_graph_new(void);
TinkerSceneCurve *tinker_scene_graph_add(TinkerSceneGraph *graph, const char *block, const char *quantity);
TinkerSceneGraph *tinker_scene_graph_copy(const TinkerSceneGraph *graph);
void tinker_scene_graph_free(TinkerSceneGraph *graph);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSceneGraph, tinker_scene_graph_free)

/* Of TinkerSceneInstrument *, controls and meters; changed by the history alone. (transfer none) */
GPtrArray *tinker_scene_instruments(TinkerScene *scene);
/* Of a control the range is 0 to 1, without steps. (transfer full) */
TinkerSceneInstrument *tinker_scene_instrument_new(TinkerInstrumentKind kind, const char *block, const char *of);
TinkerSceneInstrument *tinker_scene_instrument_copy(const TinkerSceneInstrument *instrument);
void tinker_scene_instrument_free(TinkerSceneInstrument *instrument);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSceneInstrument, tinker_scene_instrument_free)

/* The first curve that is a quantity; NULL where none is. */
const TinkerSceneCurve *tinker_scene_graph_curve(const TinkerSceneGraph *graph);

/* Blocks --------------------------------------------------------------------------------------------------------- */

/* Number of blocks, and the id of the one at `place` in drawing order. */
int32_t tinker_scene_block_count(const TinkerScene *scene);
TinkerBlockId tinker_scene_block_at(const TinkerScene *scene, int32_t place);

/* The greatest id ever given plus 1: the size of an array that is indexed by id. */
int32_t tinker_scene_id_limit(const TinkerScene *scene);
gboolean tinker_scene_has_block(const TinkerScene *scene, TinkerBlockId block);

TinkerBlockId tinker_scene_find_block(const TinkerScene *scene, const char *name);
const char *tinker_scene_block_name(const TinkerScene *scene, TinkerBlockId block);

/* The type's id, also of a placeholder; and its class, NULL for a placeholder. */
const char *tinker_scene_block_type(const TinkerScene *scene, TinkerBlockId block);
const TinkerBlockClass *tinker_scene_block_class(const TinkerScene *scene, TinkerBlockId block);

/* Adds a block with the type's defaults and detached ends at the origin. `name` NULL: the type's title and the smallest
 * free number. TINKER_NO_BLOCK on failure. */
TinkerBlockId tinker_scene_add_block(TinkerScene *scene, const TinkerBlockClass *block_class, const char *name,
                                     GError **error);

/* Removes a block and its curves, with the graphs that have no others; ends attached to it become detached at the place
 * they were, and what lay on it stays where it was. */
void tinker_scene_remove_block(TinkerScene *scene, TinkerBlockId block);
/* Graphs and the ends of placeholders follow their block's new name. */
gboolean tinker_scene_rename_block(TinkerScene *scene, TinkerBlockId block, const char *name, GError **error);

/* Properties ----------------------------------------------------------------------------------------------------- */

/* Whether a property was given, by the file or by the user; else it has its default. */
gboolean tinker_scene_property_given(const TinkerScene *scene, TinkerBlockId block, int32_t property);

/* A column's value; defaults that equal another property are resolved, one that is "as placed" is NaN. */
double tinker_scene_get(const TinkerScene *scene, TinkerBlockId block, int32_t column);

/* Sets a real, integer, switch, choice or vector property, held to the declared kind and range; `values` has as many
 * entries as the property has columns. */
gboolean tinker_scene_set(TinkerScene *scene, TinkerBlockId block, int32_t property, const double *values,
                          GError **error);
/* Back to the default. */
void tinker_scene_unset(TinkerScene *scene, TinkerBlockId block, int32_t property);

/* Whether a body lies on the top of a plate, so far (m) from its middle towards the plate's own +x: its position then
 * follows from that, as does its orientation where none is given. Setting its position ends it. */
gboolean tinker_scene_lies_on(const TinkerScene *scene, TinkerBlockId block, TinkerBlockId *plate, double *along);
/* Lays a body on the top of a plate. Its orientation follows from the plate from then on. FALSE with an error where the
 * body can lie on nothing, the plate has no top, or the top does not reach as far. */
gboolean tinker_scene_lay_on(TinkerScene *scene, TinkerBlockId block, TinkerBlockId plate, double along,
                             GError **error);

/* A number among a block's properties. */
typedef struct {
    int32_t property, component; /* of a vector 0 or 1 */
    int32_t column;              /* of the block's values */
    const TinkerPropertyType *type;
} TinkerNumber;
/* By the property's id, with ".x" or ".y" behind that of a vector; FALSE where there is none of this name. */
gboolean tinker_scene_find_number(const TinkerScene *scene, TinkerBlockId block, const char *name,
                                  TinkerNumber *number);

const char *tinker_scene_get_text(const TinkerScene *scene, TinkerBlockId block, int32_t property);
/* A block whose texts are asked for by whoever knows nothing of scenes: tinker_scene_text_of answers them, as a
 * TinkerTypedLawTextFunc whose data is a TinkerSceneTexts. */
typedef struct {
    const TinkerScene *scene;
    TinkerBlockId block;
} TinkerSceneTexts;
const char *tinker_scene_text_of(int32_t property, void *texts);
void tinker_scene_set_text(TinkerScene *scene, TinkerBlockId block, int32_t property, const char *text);

/* The waveform of a property. (transfer none); set takes a reference of its own. A table that this scene did not read
 * from a file has no form in a scene file and is left out there. */
TinkerWaveform *tinker_scene_get_waveform(const TinkerScene *scene, TinkerBlockId block, int32_t property);
void tinker_scene_set_waveform(TinkerScene *scene, TinkerBlockId block, int32_t property, TinkerWaveform *waveform);

/* Ends ----------------------------------------------------------------------------------------------------------- */

int32_t tinker_scene_end_count(const TinkerScene *scene, TinkerBlockId block);
TinkerSceneEnd tinker_scene_end(const TinkerScene *scene, TinkerBlockId block, int32_t end);

/* Attaches or detaches an end. Refuses a block that the type does not accept, a block's own end on itself, and a point
 * other than the centre of a point mass. */
gboolean tinker_scene_set_end(TinkerScene *scene, TinkerBlockId block, int32_t end, TinkerSceneEnd to, GError **error);

/* Tables --------------------------------------------------------------------------------------------------------- */

/* All blocks of one class, for whoever works on columns. Borrowed; valid until the scene changes. */
typedef struct {
    const TinkerBlockClass *block_class;
    int32_t count;
    const TinkerBlockId *ids;     /* of each row; rows are in the order of the blocks' creation */
    const double *const *columns; /* columns[c][row], as tinker_scene_get gives them; waveform columns are 0 */
    const TinkerSceneEnd *ends;   /* row by row */
    const int32_t *end_offsets; /* count + 1 entries: the ends of row r are end_offsets[r] to end_offsets[r + 1] - 1 */
} TinkerSceneTable;

int32_t tinker_scene_table_count(const TinkerScene *scene);
void tinker_scene_table(TinkerScene *scene, int32_t number, TinkerSceneTable *table);

/* The first block of a type that nobody provides, or TINKER_NO_BLOCK. */
TinkerBlockId tinker_scene_first_placeholder(const TinkerScene *scene);

/* Why the type of a placeholder is missing, as its finding says: "no plugin provides the block type ...". (transfer
 * full) */
char *tinker_scene_missing_reason(const TinkerScene *scene, TinkerBlockId placeholder);

/* The first block with a detached end, or TINKER_NO_BLOCK. */
TinkerBlockId tinker_scene_first_detached(const TinkerScene *scene);

#endif
