/* Expressions of a scene's quantities and properties: "0.5*{Mass 0.mass}*{Mass 0.vx}^2". The grammar is that of
 * waveforms; what stands in braces is BLOCK.QUANTITY, or where there is no such quantity BLOCK.PROPERTY or, of a
 * vector, BLOCK.PROPERTY.x. Values are in SI. */
#ifndef TINKER_CORE_SCENE_EXPRESSION_H
#define TINKER_CORE_SCENE_EXPRESSION_H

#include "scene/store/quantities.h"
#include "units/expression/expression-tree.h"

/* What stands in one pair of braces. */
typedef struct {
    const char *symbol; /* in the tree, with its braces: interned */
    TinkerBlockId block;
    int32_t quantity; /* number, see quantities.h; -1: a property, */
    int32_t column;   /* that has this column of the block's values */
    TinkerDimension dimension;
} TinkerReference;

typedef struct {
    TinkerExpression *tree;
    GArray *references; /* of TinkerReference, each symbol once */
} TinkerSceneExpression;

/* Errors (TINKER_WAVEFORM_ERROR) begin with "column N: " and suggest what may be meant. (transfer full) */
TinkerSceneExpression *tinker_scene_expression_new(const TinkerScene *scene, const char *text, GError **error);
void tinker_scene_expression_free(TinkerSceneExpression *expression);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSceneExpression, tinker_scene_expression_free)

/* The text once the block called `from` is called `to`; NULL where it does not name it. (transfer full) */
char *tinker_scene_expression_renamed(const char *text, const char *from, const char *to);

#endif
