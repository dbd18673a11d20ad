/* What the files that read a scene share. */
#ifndef TINKER_CORE_READER_H
#define TINKER_CORE_READER_H

#include <cjson/cJSON.h>

#include "scene/json/position-scanner.h"
#include "scene/store/scene-data.h"
#include "scene/value/findings.h"
#include "scene/value/table-source.h"

/* A place in the text: a value that begins at `root`, and from there from part to part, counted from 0. A tree of cJSON
 * has no positions, but the order of its children is that of the text; so a place costs nothing until a message needs
 * it. */
#define READER_MOST_STEPS 4
typedef struct {
    gsize root;
    int depth;
    int steps[READER_MOST_STEPS];
    gboolean key; /* the key of the last step's part instead of its value */
} JsonAt;

static inline JsonAt at_root(gsize root)
{
    return (JsonAt){.root = root};
}

static inline JsonAt at_child(JsonAt at, int step)
{
    at.steps[at.depth++] = step;
    return at;
}

static inline JsonAt at_key(JsonAt at)
{
    at.key = TRUE;
    return at;
}

typedef struct {
    TinkerFindingKind kind;
    int code;
    gsize offset;
    char *message;
} ReaderFinding;

/* A type that the scene names. */
typedef struct {
    const TinkerBlockClass *block_class; /* NULL: nobody provides it, and `message` says so */
    char *message;
    int blocks;    /* of a type that nobody provides */
    guint finding; /* the one that says so, of the first of them */
} ReaderType;

/* An end whose block had not been read when the end was. */
typedef struct {
    TinkerBlockId block;
    int32_t end;
    JsonAt name_at, at_at; /* its block's name, and its "at" */
    const char *name;
} ReaderEnd;

/* A body that lies on a block: it is joined to that when all have been read. */
typedef struct {
    TinkerBlockId block;
    JsonAt name_at, along_at; /* without depth: not given */
    const char *name;
    double along;
} ReaderPlaceOn;

typedef struct {
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    const char *text;
    gsize length;
    const char *path; /* what messages call it */
    char *folder;     /* where tables are */
    gsize document;   /* where the text's object begins */
    JsonScan scan;
    GArray *findings; /* of ReaderFinding */

    /* What messages begin with: the name of a block, or "run"; else entry `number` of the list `label`. */
    const char *label;
    const char *label_type;
    int label_number;

    /* The parts of the values that were split last, one for each step. */
    struct {
        gsize start;
        GArray *parts;
    } split[READER_MOST_STEPS];

    GHashTable *types;           /* id to ReaderType */
    GHashTable *waveforms;       /* the JSON object to the waveform */
    GHashTable *known_waveforms; /* likewise, given by whoever reads; NULL: none */
    GArray *unnamed;             /* of TinkerBlockId */
    GArray *later_ends;          /* of ReaderEnd */
    GArray *places_on;           /* of ReaderPlaceOn */
    GStringChunk *end_names;     /* of both */
    GPtrArray *block_names;      /* all, for suggestions; made when first needed */
    gint64 suggestions_left;     /* names that may still be compared */
} SceneReader;

/* Findings ----------------------------------------------------------------------------------------------------- */

gsize reader_offset(SceneReader *reader, JsonAt at);
/* Both put the label in front. The error's answer is FALSE. */
gboolean reader_error(SceneReader *reader, JsonAt at, int code, const char *format, ...) G_GNUC_PRINTF(4, 5);
void reader_warning(SceneReader *reader, JsonAt at, int code, const char *format, ...) G_GNUC_PRINTF(4, 5);
void reader_error_at(SceneReader *reader, gsize offset, int code, const char *format, ...) G_GNUC_PRINTF(4, 5);
/* Errors for the duplicate keys between two places. */
void reader_report_duplicates(SceneReader *reader, gsize start, gsize end);

void reader_label(SceneReader *reader, const char *label);
void reader_label_entry(SceneReader *reader, const char *list, int number, const char *type);

/* ` (did you mean "stiffness"?)`, or `otherwise` where no candidate is near. (transfer full) */
char *reader_suggestion(const char *word, const char *const *candidates, const char *otherwise);

/* An unknown key: a warning with the nearest of the candidates, or with all of them where none is near; the member is
 * added to `extras`, which is made where it is NULL. */
void reader_keep_unknown(SceneReader *reader, JsonAt at, const char *key, const char *const *candidates,
                         GString **extras);

/* Keeps a member whose key is not known, with a warning that ends in `suggestion`: one in brackets, or what becomes of
 * the member. */
void reader_keep_member(SceneReader *reader, JsonAt at, const char *key, const char *suggestion, GString **extras);

/* Sorts the findings into the order of the text, finds lines and columns, and adds them to `findings` (may be NULL).
 * Answers whether there are no errors; `error` is the first. */
gboolean reader_conclude(SceneReader *reader, GPtrArray *findings, GError **error);

/* Values ------------------------------------------------------------------------------------------------------- */

/* `what` is what messages call the value. FALSE or NULL: an error was reported. */
gboolean reader_number(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerDimension dimension,
                       double *value);
gboolean reader_vector(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerDimension dimension,
                       double values[2]);
const char *reader_text(SceneReader *reader, const cJSON *json, JsonAt at, const char *what);
gboolean reader_switch(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, gboolean *value);
gboolean reader_wrong_kind(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *expected);
/* A text that must be one of these; its number, or -1. */
int reader_choice(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *const *choices);
/* A property of a block, stored where it is good. */
void reader_property(SceneReader *reader, const cJSON *json, JsonAt at, SceneTable *table, int32_t row,
                     int32_t property);
/* (transfer full) */
TinkerWaveform *reader_waveform(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *property);

/* The file of a table, absolute and without links, which lies in or under the scene's folder. (transfer full) */
char *reader_table_path(const char *folder, const char *file, GError **error);

/* A table for that property from the file at `path`. (transfer full) */
TinkerWaveform *reader_table(const char *path, const TinkerTableSource *source, const TinkerPropertyType *property,
                             GError **error);

/* Whether a property can be given by a table of this kind. */
gboolean reader_table_fits(TinkerTableKind kind, const TinkerPropertyType *property, GError **error);

/* As tinker_scene_read_text; `waveforms` (may be NULL) has the waveforms that are not to be read, by their JSON object
 * on one line. */
TinkerScene *reader_read_text(TinkerCatalogue *catalogue, const char *text, gsize length, const char *path,
                              GHashTable *waveforms, GPtrArray *findings, GError **error);

/* Parts of a scene --------------------------------------------------------------------------------------------- */

/* A value of its own in the text. (transfer full) */
cJSON *reader_parse(SceneReader *reader, const JsonPart *part);

void reader_head(SceneReader *reader);
void reader_block(SceneReader *reader, int number);
/* Adds to what is told of a missing type, once, how many blocks are of it. */
void reader_count_missing(SceneReader *reader);
void reader_ends(SceneReader *reader, const cJSON *json, JsonAt at, TinkerBlockId block);
/* Reads "on" and "along" of a block, whichever of them is given. */
void reader_place_on(SceneReader *reader, const cJSON *json, JsonAt at, TinkerBlockId block);
gboolean reader_is_place_on(const TinkerBlockClass *block_class, const char *key);
/* What can only be done when all blocks have been read. */
void reader_finish_places_on(SceneReader *reader);
/* A suggestion among the names of all blocks, while comparing them does not take too long. (transfer full) */
char *reader_suggest_block(SceneReader *reader, const char *name);
/* What can only be done when all blocks have been read: names, ends that name later blocks. */
void reader_finish_blocks(SceneReader *reader);
void reader_graphs(SceneReader *reader, const JsonPart *part);
/* The list "controls" or "meters". */
void reader_instruments(SceneReader *reader, const JsonPart *part, gboolean controls);

/* Lengths and times, for what is not a property. */
extern const TinkerDimension reader_length, reader_pure;

#endif
