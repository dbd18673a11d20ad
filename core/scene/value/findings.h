/* What is wrong with a scene file, and where. */
#ifndef TINKER_CORE_FINDINGS_H
#define TINKER_CORE_FINDINGS_H

#include <glib.h>

typedef enum {
    TINKER_FINDING_ERROR,   /* the scene cannot be run */
    TINKER_FINDING_WARNING, /* an unknown key; what can be opened and saved, and not be run: a missing type or method */
} TinkerFindingKind;

/* One thing that is wrong with a scene, and where. */
typedef struct {
    TinkerFindingKind kind;
    int code;         /* TinkerSceneError */
    int line, column; /* from 1; 0 where no place is known */
    char *message;    /* block, property, what is wrong (what would be right); without file, line and column */
} TinkerFinding;

/* Where something begins in a text, from 1; columns count characters. */
typedef struct {
    int line, column;
} TinkerTextPlace;

/* Where each block begins in a scene's text, in its order, which is the drawing order of the scene as it was read; of
 * TinkerTextPlace. Empty for a text that is not JSON. (transfer full) */
GArray *tinker_scene_block_places(const char *text, gsize length);

/* An array for findings that frees them. (transfer full) */
GPtrArray *tinker_findings_new(void);

#endif
