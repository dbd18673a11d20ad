/* Tinker SDK: the edit interface, "tinker.edit/1": hit, drag and handles.
 *
 * Blocks change their properties and ends only through the editor that the host hands them, so that undo, snapping and
 * scripting work for every block.
 */
#ifndef TINKER_EDIT_H
#define TINKER_EDIT_H

#include "instance.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_EDIT_INTERFACE "tinker.edit/1"

/* Parts of a block that can be hit and dragged. */
#define TINKER_PART_NONE   (-1)
#define TINKER_PART_WHOLE  1000 /* the block itself; end n of a connector is part n; handle n is part 2000 + n */
#define TINKER_PART_HANDLE 2000
/* The handle of point n of a list of points is part 3000 + n. The host itself moves it, adds and removes points: of a
 * type with TINKER_MEANING_CENTRE_OF_MASS. */
#define TINKER_PART_POINT 3000

/* The host's side of an edit. Each call is part of the same undo step. */
typedef struct TinkerEditor {
    uint32_t struct_size;
    int32_t reserved;
    void *context; /* the host's own */
    /* Sets one number: `column` as in TinkerInstance.columns, in SI; the host holds it to the declared range. */
    void (*set)(const struct TinkerEditor *editor, int32_t column, double value);
    /* Leaves an end detached at this place. The host attaches it where the drag ends over a block. */
    void (*set_end)(const struct TinkerEditor *editor, int32_t end, double x, double y);
} TinkerEditor;

/* A grip that the host draws on a selected block. */
typedef struct TinkerHandle {
    double x, y; /* m */
    int32_t part;
    int32_t reserved;
} TinkerHandle;

typedef struct TinkerEdit {
    uint32_t struct_size;
    int32_t reserved;
    /* Required: the part under the point (m), within `reach` (m), or TINKER_PART_NONE. */
    int32_t (*hit)(const TinkerInstance *instance, double x, double y, double reach);
    /* Required: moves the part by an offset (m). */
    void (*move)(const TinkerInstance *instance, int32_t part, double dx, double dy, const TinkerEditor *editor);
    /* Required: moves the part to a place (m), as snapping to the grid wants it. */
    void (*move_absolute)(const TinkerInstance *instance, int32_t part, double x, double y, const TinkerEditor *editor);
    /* Writes at most `room` handles and answers how many there are. NULL: none. */
    int32_t (*handles)(const TinkerInstance *instance, TinkerHandle *handles, int32_t room);
} TinkerEdit;

#ifdef __cplusplus
}
#endif
#endif
