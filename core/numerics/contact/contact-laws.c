#include "numerics/contact/contact-laws.h"
#include "numerics/contact/tolerances.h"

#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/solve/largest.h"

/* Room for what is worked on. */
typedef struct {
    double few[7 * 8], *many;
    double *offset, *friction; /* 2m, m */
    double *v, *size;          /* 2m */
} Room;

/* FALSE: no memory. */
static gboolean room_init(Room *room, int32_t m)
{
    room->many = m > 8 ? g_try_new(double, 7 * (gsize)m) : NULL;
    if (m > 8 && room->many == NULL) return FALSE;
    room->offset = room->many != NULL ? room->many : room->few;
    room->friction = room->offset + 2 * m;
    room->v = room->friction + m;
    room->size = room->v + 2 * m;
    return TRUE;
}

/* Accelerations under these forces; those that are rounding become 0. */
static void accelerations(const TinkerClosedContacts *closed, const TinkerContactProblem *problem, const double *forces,
                          double *a, double *size)
{
    tinker_contact_velocities(problem, forces, a, size);
    for (int32_t i = 0; i < 2 * closed->count; i++)
        if (fabs(a[i]) <= closed->noise + TINKER_MODE_ROUNDING * size[i]) a[i] = 0;
}

static int32_t bearer_of(const TinkerClosedContacts *closed, int32_t k)
{
    return closed->bearer != NULL ? closed->bearer[k] : k;
}

static TinkerContactMode mode_of(const TinkerClosedContacts *closed, int32_t k, double force, const double *a)
{
    const int32_t bearer = bearer_of(closed, k);
    if (bearer >= 0 && a[2 * bearer] > 0 && !(force > 0)) return TINKER_CONTACT_OPEN;
    double along = closed->sliding[k] != 0 ? closed->sliding[k] : a[2 * k + 1];
    return along > 0 ? TINKER_CONTACT_SLIP_FORWARD : along < 0 ? TINKER_CONTACT_SLIP_BACKWARD : TINKER_CONTACT_STICK;
}

/* Whether it was to hold and does, short of its limit, though an answer that is found no better leaves it an
 * acceleration along (`loose` at most). A larger one is that of what others move along, where friction is of no use. */
static gboolean holds_surely(const TinkerClosedContacts *closed, int32_t k, double limit, double friction, double along,
                             double loose)
{
    return closed->sliding[k] == 0 && fabs(friction) < (1 - TINKER_AT_BOUND) * limit && fabs(along) <= loose;
}

/* Contacts that begin to slip rub from then on; with less friction they may still hold, and others may give way. */
TinkerContactResult tinker_contact_modes(const TinkerClosedContacts *closed, TinkerContactMode *modes, double *forces)
{
    int32_t m = closed->count;
    Room room;
    if (!room_init(&room, m)) return TINKER_CONTACT_NO_MEMORY;
    TinkerContactProblem problem = {m,
                                    closed->delassus,
                                    room.offset,
                                    room.friction,
                                    closed->sliding,
                                    closed->motion,
                                    closed->bearer,
                                    .any = closed->any};
    for (int32_t k = 0; k < m; k++) {
        double normal = closed->acceleration[2 * k];
        room.offset[2 * k] = fabs(normal) <= closed->noise ? 0 : normal;
        room.offset[2 * k + 1] = closed->acceleration[2 * k + 1];
        room.friction[k] = closed->sliding[k] != 0 ? closed->dynamic_friction[k] : closed->static_friction[k];
    }
    TinkerContactResult result;
    gboolean changed;
    do {
        changed = FALSE;
        result = tinker_contact_solve(&problem, forces);
        if (result != TINKER_CONTACT_SOLVED) break;
        accelerations(closed, &problem, forces, room.v, room.size);
        const double loose = TINKER_PIVOTED * tinker_largest(2 * m, room.size);
        for (int32_t k = 0; k < m; k++) {
            const double normal = tinker_contact_normal(&problem, forces, k);
            const double limit = room.friction[k] * normal;
            const gboolean holds = holds_surely(closed, k, limit, forces[2 * k + 1], room.v[2 * k + 1], loose);
            modes[k] = holds ? TINKER_CONTACT_STICK : mode_of(closed, k, normal, room.v);
            gboolean slips = modes[k] == TINKER_CONTACT_SLIP_FORWARD || modes[k] == TINKER_CONTACT_SLIP_BACKWARD;
            if (!slips || !(normal > 0) || !(room.friction[k] > closed->dynamic_friction[k])) continue;
            room.friction[k] = closed->dynamic_friction[k];
            changed = TRUE;
        }
    } while (changed);
    if (closed->relative != NULL && result == TINKER_CONTACT_SOLVED)
        memcpy(closed->relative, room.v, 2 * (gsize)m * sizeof(double));
    g_free(room.many);
    return result;
}

/* Over a moment in which accelerations change velocities by very little, forces that exist leave impulses as little;
 * impulses that the laws of impact ask for nevertheless are those of the jam. They are linear in a short moment: from a
 * whole and a half one, those of none. Source: Anitescu, Potra (1997), section 4. */
TinkerContactResult tinker_contact_jam(const TinkerClosedContacts *closed, const double *velocity, double *impulses)
{
    int32_t m = closed->count;
    Room room;
    if (!room_init(&room, m)) return TINKER_CONTACT_NO_MEMORY;
    TinkerContactProblem problem = {m,    closed->delassus, room.offset,    room.friction,
                                    NULL, closed->motion,   closed->bearer, .any = TRUE};
    double fastest = 0, hardest = 0, *half = room.v;
    for (int32_t i = 0; i < 2 * m; i++) {
        fastest = MAX(fastest, fabs(velocity[i]));
        hardest = MAX(hardest, fabs(closed->acceleration[i]));
    }
    double moment = hardest > 0 ? TINKER_MOMENT * fastest / hardest : 0;
    for (int32_t k = 0; k < m; k++)
        room.friction[k] = closed->sliding[k] != 0 ? closed->dynamic_friction[k] : closed->static_friction[k];
    for (int32_t k = 0; k < m; k++)
        if (bearer_of(closed, k) < 0) room.friction[k] = 0; /* a finite force is nothing within no time */
    TinkerContactResult result = TINKER_CONTACT_SOLVED;
    for (int32_t pass = 0; pass < 2 && result == TINKER_CONTACT_SOLVED; pass++, moment /= 2) {
        for (int32_t i = 0; i < 2 * m; i++)
            room.offset[i] =
                (i % 2 == 0 || closed->sliding[i / 2] == 0 ? 0 : velocity[i]) + moment * closed->acceleration[i];
        result = tinker_contact_solve(&problem, pass == 0 ? impulses : half);
    }
    for (int32_t k = 0; k < m && result == TINKER_CONTACT_SOLVED; k++) {
        const int32_t b = MAX(bearer_of(closed, k), 0); /* what is bounded by a number has no friction here */
        /* a bearer comes before what leans on it: its impulse is that of the jam by then */
        double normal = b != k ? impulses[2 * b] : 2 * half[2 * k] - impulses[2 * k];
        double along = 2 * half[2 * k + 1] - impulses[2 * k + 1];
        double noise = TINKER_MODE_ROUNDING * half[2 * b], most = room.friction[k] * normal;
        impulses[2 * k] = b == k && normal > noise ? normal : 0;
        impulses[2 * k + 1] = normal > noise ? CLAMP(along, -most, most) : 0;
    }
    g_free(room.many);
    return result;
}
