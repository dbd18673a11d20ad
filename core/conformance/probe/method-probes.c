/* An oscillator of any stiffness and damping, and a pendulum: what methods are tried on for stability and constraints.
 *
 * The pendulum is a point on a rod about the origin, g(q) = |q| - L = 0, in a gravity that makes small swings have the
 * frequency KIT_SYSTEM_OMEGA. With n = q / |q|, J = n and drift = (v . v - (n . v)^2) / |q|. */
#include <math.h>
#include <tinker/unconstrained.h>

#include "conformance/probe/method-systems.h"

#define SIZE KIT_SYSTEM_SIZE

/* The probe ------------------------------------------------------------------------------------------------------- */

static TinkerStatus probe_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                       double *power)
{
    const KitProbe *probe = context;
    a[0] = -probe->edge.stiffness * q[0] - probe->edge.damping * v[0];
    return TINKER_OK;
}
static TinkerStatus probe_damping(void *context, double t, const double *q, const double *v, const double *dv,
                                  double *out)
{
    const KitProbe *probe = context;
    out[0] = -probe->edge.damping * dv[0];
    return TINKER_OK;
}
static void probe_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = fmax(1, fabs(q[0]));
    *speed = fmax(1, fabs(v[0]));
}
static TinkerStatus probe_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                   double *damping)
{
    const KitProbe *probe = context;
    stiffness[0] = probe->edge.stiffness;
    damping[0] = probe->edge.damping;
    return TINKER_OK;
}
static TinkerStatus no_signals(void *context, TinkerSignal *list)
{
    return TINKER_OK;
}

static const double unit[] = {1}, anchors[] = {0};
static const int32_t one_row[] = {0, 1}, one_column[] = {0};
static const TinkerPattern one_by_one = {1, 1, one_row, one_column};

void kit_probe_begin(KitProbe *probe, double stiffness, double damping)
{
    *probe = (KitProbe){.edge = {0, -1, stiffness, 0, damping, 0}};
    probe->linear = (TinkerLinearSystem){.struct_size = sizeof(TinkerLinearSystem),
                                         .size = 1,
                                         .edge_count = 1,
                                         .anchor_count = 1,
                                         .mass = unit,
                                         .edges = &probe->edge,
                                         .anchors = anchors,
                                         .damper_book = -1,
                                         .drag_book = -1,
                                         .support_book = -1};
    probe->system = (TinkerSystem){.struct_size = sizeof(TinkerSystem),
                                   .flags = damping != 0 ? TINKER_SYSTEM_VELOCITY_DEPENDENT : 0,
                                   .size = 1,
                                   .context = probe,
                                   .mass = unit,
                                   .acceleration = probe_acceleration,
                                   .applied = probe_acceleration,
                                   .project = tinker_unconstrained_project,
                                   .constrain_step = tinker_unconstrained_constrain_step,
                                   .project_velocity = tinker_unconstrained_project_velocity,
                                   .damping_product = probe_damping,
                                   .scales = probe_scales,
                                   .failure = tinker_unconstrained_failure,
                                   .pattern = &one_by_one,
                                   .jacobian = probe_jacobian,
                                   .linear = &probe->linear,
                                   .signals = no_signals};
}

/* The pendulum ---------------------------------------------------------------------------------------------------- */

#define LENGTH  KIT_PENDULUM_LENGTH
#define GRAVITY (KIT_SYSTEM_OMEGA * KIT_SYSTEM_OMEGA * LENGTH)
#define MASS    2.0
#define NEWTONS 20

static TinkerStatus pull_down(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    a[0] = 0;
    a[1] = -GRAVITY;
    return TINKER_OK;
}
static TinkerStatus swing(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    const double length = hypot(q[0], q[1]);
    if (!(length > 0)) return TINKER_RETRY_SMALLER;
    const double nx = q[0] / length, ny = q[1] / length, along = nx * v[0] + ny * v[1];
    const double drift = (v[0] * v[0] + v[1] * v[1] - along * along) / length, held = -ny * GRAVITY + drift;
    a[0] = -nx * held;
    a[1] = -GRAVITY - ny * held;
    return TINKER_OK;
}
static TinkerStatus project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous)
{
    const double length = hypot(q[0], q[1]);
    if (!(length > 0)) return TINKER_RETRY_SMALLER;
    const double nx = q[0] / length, ny = q[1] / length, along = nx * v[0] + ny * v[1];
    v[0] -= nx * along;
    v[1] -= ny * along;
    return TINKER_OK;
}
static TinkerStatus project(void *context, double t, double *q, double *v, int32_t *moved)
{
    const double before[] = {q[0], q[1], v[0], v[1]}, length = hypot(q[0], q[1]);
    if (!(length > 0)) return TINKER_RETRY_SMALLER;
    q[0] *= LENGTH / length;
    q[1] *= LENGTH / length;
    project_velocity(context, t, q, v, 0);
    *moved = q[0] != before[0] || q[1] != before[1] || v[0] != before[2] || v[1] != before[3];
    return TINKER_OK;
}
static TinkerStatus constrain_step(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v)
{
    const double length = hypot(q_from[0], q_from[1]), nx = q_from[0] / length, ny = q_from[1] / length;
    for (int i = 0; i < NEWTONS; i++) {
        const double now = hypot(q[0], q[1]), slope = (nx * q[0] + ny * q[1]) / now;
        if (!(slope > 0.1)) return TINKER_RETRY_SMALLER;
        const double by = -(now - LENGTH) / slope;
        q[0] += nx * by;
        q[1] += ny * by;
        v[0] += nx * by / h;
        v[1] += ny * by / h;
    }
    return TINKER_OK;
}
static TinkerStatus no_damping(void *context, double t, const double *q, const double *v, const double *dv, double *out)
{
    out[0] = out[1] = 0;
    return TINKER_OK;
}
static void pendulum_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = LENGTH;
    *speed = KIT_SYSTEM_OMEGA * LENGTH;
}
static TinkerStatus no_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                double *damping)
{
    for (int i = 0; i < SIZE * SIZE; i++)
        stiffness[i] = damping[i] = 0;
    return TINKER_OK;
}
static TinkerStatus row_masses(void *context, double t, const double *q, double *values)
{
    const double length = hypot(q[0], q[1]), n[] = {q[0] / length, q[1] / length};
    for (int i = 0; i < SIZE * SIZE; i++)
        values[i] = MASS * n[i / SIZE] * n[i % SIZE];
    return TINKER_OK;
}

static const double masses[SIZE] = {MASS, MASS};
static const int32_t full_rows[] = {0, 2, 4}, full_columns[] = {0, 1, 0, 1};
static const TinkerPattern full = {SIZE, SIZE *SIZE, full_rows, full_columns};

const TinkerSystem kit_pendulum = {.struct_size = sizeof(TinkerSystem),
                                   .flags = TINKER_SYSTEM_CONSTRAINED,
                                   .size = SIZE,
                                   .mass = masses,
                                   .acceleration = swing,
                                   .applied = pull_down,
                                   .project = project,
                                   .constrain_step = constrain_step,
                                   .project_velocity = project_velocity,
                                   .damping_product = no_damping,
                                   .scales = pendulum_scales,
                                   .failure = tinker_unconstrained_failure,
                                   .pattern = &full,
                                   .jacobian = no_jacobian,
                                   .row_masses = row_masses};

void kit_pendulum_start(double q[KIT_SYSTEM_SIZE], double v[KIT_SYSTEM_SIZE])
{
    const double angle = 1.0, speed = 0.7;
    q[0] = LENGTH * sin(angle);
    q[1] = -LENGTH * cos(angle);
    v[0] = speed * cos(angle);
    v[1] = speed * sin(angle);
}
