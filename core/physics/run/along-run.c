/* The length of a path is the integral of the speed. The energies are those of the books, which integrators carry
 * along, and of impacts. */
#include "physics/run/along-run.h"

#include <math.h>
#include <string.h>

#include "numerics/roots/quadrature.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/record/columns.h"
#include "physics/run/tolerances.h"

/* The bodies of one island whose paths are wanted. */
typedef struct {
    TinkerIslandRun *run;
    GArray *bodies; /* of int32_t: in the island */
    GArray *columns;
    double *lengths; /* m, up to: */
    double until;    /* s */
} Paths;

typedef struct {
    guint column;
    int32_t number;
} Wanted;

struct _TinkerAlongRun {
    TinkerModel *model;
    const GPtrArray *runs;
    Paths *paths;     /* one an island */
    GArray *energies; /* of Wanted */
    double *q, *v;    /* room: of the largest island; */
    double *room, *books;
    double stored_at_start; /* J: in force elements and fields that are asked */
};

static gboolean add_path(TinkerAlongRun *self, const TinkerColumn *column, guint number)
{
    const int32_t body = tinker_model_centre(self->model, column->block);
    for (guint i = 0; i < self->runs->len; i++) {
        Paths *paths = &self->paths[i];
        for (int32_t k = 0; k < paths->run->model->bodies; k++) {
            if (paths->run->island->body_of[k] != body) continue;
            g_array_append_val(paths->bodies, k);
            g_array_append_val(paths->columns, number);
            return TRUE;
        }
    }
    return FALSE;
}

static gboolean adds_up(const TinkerColumn *column)
{
    if (column->block != TINKER_NO_BLOCK) return column->quantity == TINKER_IMPLIED_PATH_LENGTH;
    return column->quantity >= TINKER_SCENE_DAMPERS && column->quantity <= TINKER_SCENE_SUPPLIED;
}

static void open_paths(TinkerAlongRun *self)
{
    self->paths = g_new0(Paths, MAX(self->runs->len, 1));
    for (guint i = 0; i < self->runs->len; i++) {
        Paths *paths = &self->paths[i];
        paths->run = g_ptr_array_index(self->runs, i);
        paths->bodies = g_array_new(FALSE, FALSE, sizeof(int32_t));
        paths->columns = g_array_new(FALSE, FALSE, sizeof(guint));
        const TinkerEnergy *start = &paths->run->books.start;
        self->stored_at_start += start->stored_in_forces + start->stored_in_fields;
    }
}

TinkerAlongRun *tinker_along_run_new(TinkerModel *model, const GPtrArray *runs, const GArray *columns)
{
    gboolean any = FALSE;
    for (guint c = 0; columns != NULL && c < columns->len; c++)
        any |= adds_up(&g_array_index(columns, TinkerColumn, c));
    if (!any) return NULL;
    TinkerAlongRun *self = g_new0(TinkerAlongRun, 1);
    self->model = model;
    self->runs = runs;
    self->energies = g_array_new(FALSE, FALSE, sizeof(Wanted));
    open_paths(self);
    for (guint c = 0; c < columns->len; c++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, c);
        if (!adds_up(column)) continue;
        Wanted wanted = {c, column->quantity};
        if (column->block != TINKER_NO_BLOCK)
            add_path(self, column, c);
        else
            g_array_append_val(self->energies, wanted);
    }
    const gsize size = (gsize)MAX(model->coordinates, 1);
    self->q = g_new0(double, size);
    self->v = g_new0(double, size);
    self->room = g_new0(double, 3 * size);
    self->books = g_new0(double, TINKER_BOOK_COUNT);
    for (guint i = 0; i < runs->len; i++)
        self->paths[i].lengths = g_new0(double, self->paths[i].bodies->len + 1);
    return self;
}

void tinker_along_run_free(TinkerAlongRun *self)
{
    if (self == NULL) return;
    for (guint i = 0; i < self->runs->len; i++) {
        g_array_unref(self->paths[i].bodies);
        g_array_unref(self->paths[i].columns);
        g_free(self->paths[i].lengths);
    }
    g_array_unref(self->energies);
    gpointer arrays[] = {self->paths, self->q, self->v, self->room, self->books};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

typedef struct {
    TinkerAlongRun *self;
    const Paths *paths;
    double noise; /* m/s */
} Speeds;

static TinkerStatus speeds_at(double t, double *values, void *data)
{
    const Speeds *speeds = data;
    const double *v = speeds->self->v;
    TinkerStatus status = tinker_island_run_state_at(speeds->paths->run, t, speeds->self->q, speeds->self->v);
    for (guint i = 0; i < speeds->paths->bodies->len; i++) {
        const int32_t body = g_array_index(speeds->paths->bodies, int32_t, i);
        values[i] = hypot(v[2 * body], v[2 * body + 1]);
    }
    return status;
}

/* A velocity of the body in this place of the list, at t. */
static void velocity_at(const Speeds *speeds, guint place, double t, double velocity[2])
{
    const int32_t body = g_array_index(speeds->paths->bodies, int32_t, place);
    (void)tinker_island_run_state_at(speeds->paths->run, t, speeds->self->q, speeds->self->v);
    memcpy(velocity, speeds->self->v + 2 * body, 2 * sizeof(double));
}

/* Whether a body came back: one that all but stands has no direction. */
static gboolean turns_back(const double from[2], const double to[2], double least)
{
    const double product = from[0] * to[0] + from[1] * to[1];
    return product < 0 && hypot(from[0], from[1]) > least && hypot(to[0], to[1]) > least;
}

/* The time between the two at which a body turns back: v . (v_to - v_from) changes its sign there. */
static double turning_point(const Speeds *speeds, guint place, double from, double to, const double v_from[2],
                            const double v_to[2])
{
    const double across[2] = {v_to[0] - v_from[0], v_to[1] - v_from[1]};
    for (;;) {
        const double middle = 0.5 * (from + to);
        double v[2];
        if (!(from < middle && middle < to)) return middle;
        velocity_at(speeds, place, middle, v);
        if (v[0] * across[0] + v[1] * across[1] < 0)
            from = middle;
        else
            to = middle;
    }
}

/* Where a body comes back the way that it went its speed has a kink at 0. */
static double kink_between(double from, double to, void *data)
{
    const Speeds *speeds = data;
    const double times[3] = {from, 0.5 * (from + to), to};
    for (guint place = 0; place < speeds->paths->bodies->len; place++) {
        double v[3][2], fastest = 0;
        for (int k = 0; k < 3; k++) {
            velocity_at(speeds, place, times[k], v[k]);
            fastest = fmax(fastest, hypot(v[k][0], v[k][1]));
        }
        for (int k = 0; k < 2; k++)
            if (turns_back(v[k], v[k + 1], fmax(TINKER_TURNS_BACK * fastest, speeds->noise)))
                return turning_point(speeds, place, times[k], times[k + 1], v[k], v[k + 1]);
    }
    return NAN;
}

/* What rounding makes of the speed of a body that stands still while others of its island move. */
static double speed_noise(TinkerIslandRun *run)
{
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    return fmax(TINKER_PATH_TOLERANCE * speed, tinker_island_run_speed_noise(run, extent));
}

TinkerStatus tinker_along_run_follow(TinkerAlongRun *self, guint island, double t)
{
    Paths *paths = &self->paths[island];
    if (paths->bodies->len == 0 || !(t > paths->until)) return TINKER_OK;
    Speeds speeds = {self, paths, speed_noise(paths->run)};
    TinkerStatus status = tinker_integrate(speeds_at, kink_between, &speeds, (int32_t)paths->bodies->len, paths->until,
                                           t, TINKER_PATH_TOLERANCE, speeds.noise, paths->lengths, self->room);
    paths->until = t;
    return status;
}

/* A linear form books what force elements do not store of what they give, as the summary does (system/books.c). */
static TinkerStatus take_stored(TinkerAlongRun *self, TinkerIslandRun *run, double t, double *given)
{
    TinkerEnergy now = {0};
    if (run->system.form == NULL) return TINKER_OK;
    TinkerStatus status = tinker_island_run_state_at(run, t, self->q, self->v);
    if (status == TINKER_OK) status = tinker_model_set_time(run->model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(run->model, self->q, self->v);
    status = tinker_model_energy(run->model, &now);
    given[TINKER_BOOK_MOTORS] -= now.stored_in_forces - run->books.start.stored_in_forces;
    return status;
}

/* J that an island was given by t, by book; without what force elements and fields store. */
static TinkerStatus add_books(TinkerAlongRun *self, TinkerIslandRun *run, double t, double *given)
{
    const double *books = run->state.books;
    TinkerStatus status = TINKER_OK;
    if (t != run->state.t && run->system.system.books > 0) {
        status = tinker_island_run_interpolate(run, t, self->q, self->v, self->books);
        books = self->books;
    }
    for (int32_t i = 0; i < run->system.system.books; i++)
        given[run->system.book_of[i]] += books[i];
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        given[book] += run->system.impact_work[book];
    return status == TINKER_OK ? take_stored(self, run, t, given) : status;
}

static double energy_of(const double *given, int32_t number)
{
    switch (number) {
    case TINKER_SCENE_DAMPERS:
        return -given[TINKER_BOOK_DAMPERS];
    case TINKER_SCENE_FRICTION:
        return -given[TINKER_BOOK_FRICTION];
    case TINKER_SCENE_IMPACTS:
        return -given[TINKER_BOOK_CONTACTS];
    case TINKER_SCENE_DISSIPATED:
        return -given[TINKER_BOOK_DAMPERS] - given[TINKER_BOOK_FRICTION] - given[TINKER_BOOK_CONTACTS];
    default:
        return given[TINKER_BOOK_MOTORS] + given[TINKER_BOOK_FIELDS] + given[TINKER_BOOK_SUPPORT_MOTION];
    }
}

TinkerStatus tinker_along_run_values(TinkerAlongRun *self, double t, double *values)
{
    double given[TINKER_BOOK_COUNT] = {0};
    TinkerEnergy now = {0};
    /* before the books: a method may evaluate powers for them at times before t, which moves the points of the model */
    TinkerStatus status = self->energies->len > 0 ? tinker_model_energy(self->model, &now) : TINKER_OK;
    for (guint i = 0; i < self->runs->len; i++) {
        const Paths *paths = &self->paths[i];
        for (guint k = 0; k < paths->columns->len; k++)
            values[g_array_index(paths->columns, guint, k)] = paths->lengths[k];
        if (self->energies->len > 0 && status == TINKER_OK) status = add_books(self, paths->run, t, given);
    }
    if (self->energies->len == 0 || status != TINKER_OK) return status;
    given[TINKER_BOOK_MOTORS] += now.stored_in_forces + now.stored_in_fields - self->stored_at_start;
    for (guint i = 0; i < self->energies->len; i++) {
        const Wanted *wanted = &g_array_index(self->energies, Wanted, i);
        values[wanted->column] = energy_of(given, wanted->number);
    }
    return status;
}
