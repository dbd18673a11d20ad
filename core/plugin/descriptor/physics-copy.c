/* The physics interface with its roles: each role is a struct of its own that grows by itself. */
#include "plugin/descriptor/class-build.h"
#include "plugin/descriptor/copy.h"
#include "plugin/trust/refuse.h"

#define LEAST_HEAD   8
#define MOST_SCRATCH (1 << 30)

/* Copies the role behind a pointer of the vtable and puts the copy in its place. */
#define COPY_ROLE(physics, member, type, arena, error)                                                                 \
    ((physics)->member == NULL ||                                                                                      \
     ((physics)->member =                                                                                              \
          tinker_struct_copy((physics)->member, #type,                                                                 \
                             ((TinkerShape){LEAST_HEAD, sizeof(type), _Alignof(type), TRUE}), arena, error)) != NULL)

static gboolean copy_roles(TinkerPhysics *physics, GPtrArray *arena, GError **error)
{
    return COPY_ROLE(physics, body, TinkerBody, arena, error) &&
           COPY_ROLE(physics, line_law, TinkerLineLaw, arena, error) &&
           COPY_ROLE(physics, force_element, TinkerForceElement, arena, error) &&
           COPY_ROLE(physics, field, TinkerField, arena, error) &&
           COPY_ROLE(physics, constraint, TinkerConstraint, arena, error) &&
           COPY_ROLE(physics, motion, TinkerMotion, arena, error);
}

static gboolean lacks(const char *role, const char *function, GError **error)
{
    return tinker_refuse(error, "its %s lacks the required function \"%s\"", role, function);
}

static gboolean check_functions(const TinkerPhysics *physics, GError **error)
{
    if (physics->line_law != NULL && physics->line_law->tension == NULL) return lacks("line law", "tension", error);
    if (physics->force_element != NULL && physics->force_element->force == NULL)
        return lacks("force element", "force", error);
    if (physics->force_element != NULL && physics->force_element->next_blow != NULL &&
        physics->force_element->blow == NULL)
        return lacks("force element", "blow", error);
    if (physics->field != NULL && physics->field->force == NULL) return lacks("field", "force", error);
    if (physics->constraint != NULL && physics->constraint->rows_at == NULL)
        return lacks("constraint", "rows_at", error);
    if (physics->motion != NULL && physics->motion->motion == NULL && physics->motion->rotation == NULL)
        return lacks("motion", "motion", error);
    if (physics->constraint != NULL && physics->constraint->friction != NULL && physics->constraint->rows != 2)
        return tinker_refuse(error, "its constraint has friction and %d rows, 2 were expected",
                             physics->constraint->rows);
    if (physics->constraint != NULL && physics->constraint->rows < 1)
        return tinker_refuse(error, "its constraint has %d rows, at least 1 was expected", physics->constraint->rows);
    return TRUE;
}

static gboolean check_roles(const TinkerPhysics *physics, GError **error)
{
    const int others = (physics->line_law != NULL) + (physics->force_element != NULL) + (physics->field != NULL) +
                       (physics->constraint != NULL) + (physics->motion != NULL);
    if (others > 1)
        return tinker_refuse(error, "its physics fills %d roles, the body's and one more at most were expected",
                             others + (physics->body != NULL));
    if (others == 0 && physics->body == NULL) return tinker_refuse(error, "its physics fills no role");
    if (others > 0 && physics->body != NULL && physics->field == NULL)
        return tinker_refuse(error, "it is a body and fills another role, that of a field alone goes with it (a field "
                                    "acts on all bodies, this one among them)");
    return TRUE;
}

static gboolean check_ends(const char *role, int32_t expected, const TinkerBlockType *type, GError **error)
{
    if (type->least_ends == expected && type->most_ends == expected) return TRUE;
    return tinker_refuse(error, "it is a %s and has %d to %d ends, %d was expected", role, type->least_ends,
                         type->most_ends, expected);
}

static gboolean check_role_ends(const TinkerPhysics *physics, const TinkerBlockType *type, GError **error)
{
    if (physics->body != NULL) return check_ends("body", 0, type, error);
    if (physics->line_law != NULL) return check_ends("line law", 2, type, error);
    if (physics->motion != NULL) return check_ends("motion", 1, type, error);
    if (physics->field != NULL) return check_ends("field", 0, type, error);
    return TRUE;
}

static gboolean needs_meaning(const TinkerBlockClass *block_class, int32_t meaning, const char *name, GError **error)
{
    return block_class->meanings[meaning] >= 0 || tinker_refuse(error, "it is a body, but no property means %s", name);
}

static gboolean needs_as_shaped(const TinkerBlockClass *block_class)
{
    gboolean needs = FALSE;
    for (int32_t i = 0; i < block_class->property_count; i++)
        needs |= (block_class->properties[i].flags & TINKER_DEFAULT_AS_SHAPED) != 0;
    return needs;
}

static gboolean check_body(const TinkerBody *body, const TinkerBlockClass *block_class, GError **error)
{
    if (body == NULL) return TRUE;
    const int32_t freedoms = body->degrees_of_freedom;
    if (freedoms != 0 && freedoms != 2 && freedoms != 3)
        return tinker_refuse(error, "its body has %d degrees of freedom, 0, 2 or 3 was expected", freedoms);
    if (body->shape < TINKER_SHAPE_NONE || body->shape > TINKER_SHAPE_OUTLINE)
        return tinker_refuse(error, "its body has the shape %d, %d to %d was expected", body->shape, TINKER_SHAPE_NONE,
                             TINKER_SHAPE_OUTLINE);
    if (body->as_shaped == NULL && needs_as_shaped(block_class)) return lacks("body", "as_shaped", error);
    return needs_meaning(block_class, TINKER_MEANING_POSITION, "its position", error) &&
           (freedoms < 2 || needs_meaning(block_class, TINKER_MEANING_MASS, "its mass", error)) &&
           (freedoms < 3 || needs_meaning(block_class, TINKER_MEANING_INERTIA, "its inertia", error));
}

const TinkerPhysics *tinker_physics_copy(const void *vtable, const TinkerBlockClass *block_class, GPtrArray *arena,
                                         GError **error)
{
    const TinkerShape shape = {LEAST_HEAD, sizeof(TinkerPhysics), _Alignof(TinkerPhysics), TRUE};
    TinkerPhysics *physics = tinker_struct_copy(vtable, "\"" TINKER_PHYSICS_INTERFACE "\"", shape, arena, error);
    if (physics == NULL) return NULL;
    if (physics->scratch_size < 0 || physics->scratch_size > MOST_SCRATCH) {
        tinker_refuse(error, "its physics asks for %d bytes of scratch, 0 to %d was expected", physics->scratch_size,
                      MOST_SCRATCH);
        return NULL;
    }
    const gboolean passed = copy_roles(physics, arena, error) && check_roles(physics, error) &&
                            check_functions(physics, error) && check_body(physics->body, block_class, error) &&
                            check_role_ends(physics, block_class->type, error);
    return passed ? physics : NULL;
}
