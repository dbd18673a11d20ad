/* Which rods and bodies make a tree on one support. */
#include "equations/angles/angles-private.h"

/* Each equation has terms of all angles, over all bodies beyond them: longer ones are nothing to read. */
#define MOST_ANGLES 24

const TinkerBodyEquation *tinker_angle_body(const TinkerEquations *equations, TinkerBlockId block)
{
    for (guint i = 0; i < equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(equations->bodies, i);
        if (body->block == block) return body;
    }
    return NULL;
}

static int angle_of_body(const TinkerAngleTree *tree, TinkerBlockId body)
{
    for (guint i = 0; i < tree->angles->len; i++)
        if (tinker_angle_at(tree, (int)i)->body == body) return (int)i;
    return -1;
}

static gboolean has_link(const TinkerAngleTree *tree, TinkerBlockId block)
{
    for (guint i = 0; i < tree->angles->len; i++)
        if (tinker_angle_at(tree, (int)i)->line->block == block) return TRUE;
    return FALSE;
}

/* A rod moves a point mass, a pin a body that turns; FALSE for the others. */
static gboolean add_angle(TinkerAngleTree *tree, const TinkerEquations *equations, const TinkerLineEquation *line,
                          int near, int before)
{
    const TinkerBodyEquation *body = tinker_angle_body(equations, line->ends[1 - near]);
    const gboolean pin = tinker_expression_is_number(line->tension, 0);
    if (body == NULL || pin != (body->inertia != NULL)) return FALSE;
    const TinkerRodAngle angle = {.rod = pin ? body->block : line->block,
                                  .body = body->block,
                                  .before = before,
                                  .line = line,
                                  .near = near,
                                  .turns = pin};
    g_array_append_val(tree->angles, angle);
    return TRUE;
}

/* Everything in the list that hangs on the angle's body; FALSE where something closes a ring, holds on to a second
 * support, or gives no angle. */
static gboolean grow_from(TinkerAngleTree *tree, const TinkerEquations *equations, const GPtrArray *list, int number)
{
    const TinkerBlockId body = tinker_angle_at(tree, number)->body;
    for (guint k = 0; k < list->len; k++) {
        const TinkerLineEquation *line = g_ptr_array_index(list, k);
        const int near = line->ends[0] == body ? 0 : line->ends[1] == body ? 1 : -1;
        if (near < 0 || has_link(tree, line->block)) continue;
        if (line->ends[1 - near] < 0 || angle_of_body(tree, line->ends[1 - near]) >= 0) return FALSE;
        if (!add_angle(tree, equations, line, near, number)) return FALSE;
    }
    return TRUE;
}

/* Whether the tree alone holds its bodies, and nothing touches them. */
static const char *held_otherwise(const TinkerAngleTree *tree, const TinkerEquations *equations)
{
    for (guint i = 0; i < tree->angles->len; i++) {
        const TinkerBodyEquation *body = tinker_angle_body(equations, tinker_angle_at(tree, (int)i)->body);
        for (guint k = 0; k < body->terms->len; k++) {
            const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, k);
            if (term->kind == TINKER_TERM_NORMAL) return "it lies on something";
            if (term->kind == TINKER_TERM_CONSTRAINT && !has_link(tree, term->block))
                return "something else than rods and pins holds it";
        }
    }
    return NULL;
}

const char *tinker_angle_tree_fill(TinkerAngleTree *tree, const TinkerEquations *equations,
                                   const TinkerLineEquation *line, int near)
{
    gboolean good = add_angle(tree, equations, line, near, -1);
    for (guint i = 0; i < tree->angles->len && good; i++)
        good =
            grow_from(tree, equations, equations->rods, (int)i) && grow_from(tree, equations, equations->pins, (int)i);
    if (!good) return "its rods and pins are no tree of angles on one support";
    return tree->angles->len > MOST_ANGLES ? "it has too many angles to be written out (24 can be)"
                                           : held_otherwise(tree, equations);
}
