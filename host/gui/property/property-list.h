/* The properties of what is selected, as rows to show and to set from what is typed. No widget.
 *
 * One block: everything that its descriptor declares, its name, what it is connected to, what it is now, and the
 * properties that blocks attached to it show in its panel. Several of one type: what they have in common. None: those
 * of the scene.
 */
#ifndef TINKER_GUI_PROPERTY_LIST_H
#define TINKER_GUI_PROPERTY_LIST_H

#include "gui/document/player.h"

typedef enum {
    TINKER_ROW_NUMBER,  /* text: a number with a unit */
    TINKER_ROW_TEXT,    /* any text */
    TINKER_ROW_CHOICE,  /* one of `choices` */
    TINKER_ROW_SWITCH,  /* `chosen` is 0 or 1 */
    TINKER_ROW_END,     /* text: the name of the block that an end is on; it may be detached */
    TINKER_ROW_READING, /* text that nobody types: the present value of a quantity */
} TinkerRowKind;

typedef struct _TinkerPropertyRow TinkerPropertyRow;
struct _TinkerPropertyRow {
    TinkerRowKind kind;
    char *group, *title;
    char *id;           /* unlike that of any other row of the list; the same for the same property of another block */
    char *text;         /* as shown, in the displayed units; "" where there is no value, or several */
    char *hint;         /* for a line below it, what it comes to in this scene; NULL: nothing to say */
    char *description;  /* for a tooltip: what it is, its symbol, range and default */
    const char *unit;   /* displayed; "" where there is none. Static or interned */
    char *control;      /* the number of the selected block that a control can turn (scene.h); NULL: none */
    gboolean sensitive; /* FALSE: shown, but it cannot be set, or plays no part as things are */
    gboolean given;     /* FALSE: it has its default */
    gboolean mixed;     /* the blocks selected have several values */
    gboolean is_law;    /* of a text: a law that is typed */
    GStrv choices;      /* of a choice */
    int file_choice;    /* of a choice: the one that a file has to be named for, or -1 */
    int chosen;         /* of a choice or switch; -1 where the blocks selected have several */

    /* Where it comes from; for the list's own files. */
    GArray *blocks;  /* of TinkerBlockId: which are set */
    char *sorted_by; /* the title, or that of the vector whose components stay together in their order */
    int32_t property, component;
    gconstpointer data;
    gboolean (*set)(TinkerDocument *document, const TinkerPropertyRow *row, const char *text, GError **error);
    gboolean (*choose)(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error);
};

/* Groups and rows in alphabetical order, but for the components of a vector, which stay together in theirs. Of
 * TinkerPropertyRow *. `trims`: numbers that are edited have no zeros at the end of their five decimals. (transfer
 * full) */
GPtrArray *tinker_property_list_new(TinkerDocument *document, TinkerPlayer *player, gboolean trims);

/* Tells the rows that are the frequency of what drives the scene near a resonance; `responses` as in modes-task.h,
 * NULL: not known. Answers whether there are rows of frequencies that drive it. */
gboolean tinker_property_list_hint_resonances(GPtrArray *rows, TinkerScene *scene, const GPtrArray *responses);

/* What the list is of: "Mass 0", "3 Blocks", or the scene. (transfer full) */
char *tinker_property_list_heading(TinkerDocument *document);

TinkerPropertyRow *tinker_property_row_ref(TinkerPropertyRow *row);
void tinker_property_row_unref(TinkerPropertyRow *row);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerPropertyRow, tinker_property_row_unref)

/* Whether both set the same thing of the same blocks. */
gboolean tinker_property_row_same_target(const TinkerPropertyRow *a, const TinkerPropertyRow *b);

/* Sets what a row is of from text, as one step for undo; the same text as is shown does nothing. A number may have any
 * unit of its dimension; a plain one is in the unit that is shown. Where a default follows from others ("as placed"),
 * empty text goes back to it. FALSE with an error that is a whole sentence, and the scene as it was. */
gboolean tinker_property_row_set(TinkerDocument *document, const TinkerPropertyRow *row, const char *text,
                                 GError **error);

/* Sets a choice, by its number, or a switch, 0 or 1. */
gboolean tinker_property_row_choose(TinkerDocument *document, const TinkerPropertyRow *row, int choice, GError **error);

/* Tables in files, for a row with a `file_choice`
 * ----------------------------------------------------------------------- */

/* Whether the file is a table that the row can take. One that lies outside of the folder of the document's file has to
 * be copied there: `copy` is under what name, else NULL (transfer full). FALSE with an error; that of a file that is no
 * table says line and column. */
gboolean tinker_property_row_check_file(TinkerDocument *document, const TinkerPropertyRow *row, const char *path,
                                        char **copy, GError **error);

/* Takes the file, copied if it has to be, as one step for undo; a file is never overwritten. FALSE with an error, and
 * scene and folder as they were. */
gboolean tinker_property_row_choose_file(TinkerDocument *document, const TinkerPropertyRow *row, const char *path,
                                         GError **error);

/* The title of the group that is closed until somebody opens it: how the motion is computed. Borrowed. */
const char *tinker_property_group_folded(void);

/* The id of the row in it that chooses the law of impact. (transfer full) */
char *tinker_property_law_of_impact_id(void);

#endif
