/* Lines in parts; see the header. */
#include "physics/force/line-parts.h"

#include <string.h>

#include "numerics/sharing/sharing.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"

/* Fewer lines are worked out before a helper has come. */
#define LEAST_LINES 16384
/* Enough for several threads to end together; more would have more slots. */
#define MOST_PARTS     32
#define LINES_PER_PART 4096

typedef struct {
    int32_t first_line, first_point, first_slot; /* slots are numbered behind the points */
    int32_t first_incoming;
} Part;

struct _TinkerLineParts {
    int32_t count;
    Part part[MOST_PARTS + 1]; /* and the end of the last */
    int32_t *slots;            /* of each line: where the force on its second end is added up */
    int32_t *incoming;         /* slots with forces on the points of each part, in their order */
    int32_t *targets;          /* of each incoming slot: the point */
    double taken[MOST_PARTS];  /* W: of each part */
};

/* The number of the first line from `line` on that begins at another point than the one before it. */
static int32_t next_point(const TinkerMergedLines *lines, int32_t line)
{
    while (line > 0 && line < lines->count && lines->a[line] == lines->a[line - 1])
        line++;
    return line;
}

static void cut(TinkerLineParts *self, const TinkerMergedLines *lines, int32_t points)
{
    int32_t wanted = CLAMP(lines->count / LINES_PER_PART, 1, MOST_PARTS);
    for (int32_t k = 0; k < wanted; k++) {
        int32_t line = next_point(lines, (int32_t)((gint64)lines->count * k / wanted));
        if (line >= lines->count || (k > 0 && line == self->part[self->count - 1].first_line)) continue;
        self->part[self->count++] = (Part){.first_line = line, .first_point = k == 0 ? 0 : lines->a[line]};
    }
    self->part[self->count] = (Part){.first_line = lines->count, .first_point = points};
}

static int32_t part_of(const TinkerLineParts *self, int32_t point)
{
    int32_t k = 0;
    while (point >= self->part[k + 1].first_point)
        k++;
    return k;
}

/* Numbers the slots; answers the points that they stand for. */
static GArray *number_slots(TinkerLineParts *self, const TinkerMergedLines *lines, int32_t points)
{
    GArray *targets = g_array_new(FALSE, FALSE, sizeof(int32_t));
    g_autofree int32_t *known = g_new(int32_t, points); /* the slot of a point, if it is one of this part's */
    memset(known, 0xff, (gsize)points * sizeof(int32_t));
    for (int32_t k = 0; k < self->count; k++) {
        int32_t first_slot = self->part[k].first_slot = points + (int32_t)targets->len;
        for (int32_t i = self->part[k].first_line; i < self->part[k + 1].first_line; i++) {
            int32_t b = lines->b[i];
            self->slots[i] = b;
            if (b < self->part[k + 1].first_point) continue;
            if (known[b] < first_slot) {
                known[b] = points + (int32_t)targets->len;
                g_array_append_val(targets, b);
            }
            self->slots[i] = known[b];
        }
    }
    self->part[self->count].first_slot = points + (int32_t)targets->len;
    return targets;
}

static void list_incoming(TinkerLineParts *self, const GArray *targets, int32_t points)
{
    int32_t next = 0;
    self->incoming = g_new(int32_t, MAX(targets->len, 1));
    self->targets = g_new(int32_t, MAX(targets->len, 1));
    g_autofree int32_t *owner = g_new(int32_t, MAX(targets->len, 1));
    for (guint s = 0; s < targets->len; s++)
        owner[s] = part_of(self, g_array_index(targets, int32_t, s));
    for (int32_t k = 0; k < self->count; k++) {
        self->part[k].first_incoming = next;
        for (guint s = 0; s < targets->len; s++) {
            if (owner[s] != k) continue;
            self->incoming[next] = points + (int32_t)s;
            self->targets[next++] = g_array_index(targets, int32_t, s);
        }
    }
    self->part[self->count].first_incoming = next;
}

TinkerLineParts *tinker_line_parts_new(TinkerModel *model)
{
    const TinkerMergedLines *lines = &model->lines;
    if (lines->count < LEAST_LINES) return NULL;
    TinkerLineParts *self = g_new0(TinkerLineParts, 1);
    self->slots = g_new(int32_t, lines->count);
    cut(self, lines, model->points);
    g_autoptr(GArray) targets = number_slots(self, lines, model->points);
    if (self->count < 2 || targets->len > (guint)lines->count / 4) {
        tinker_line_parts_free(self);
        return NULL;
    }
    list_incoming(self, targets, model->points);
    gsize old = 2 * (gsize)model->points, added = 2 * (gsize)targets->len;
    model->force = g_renew(double, model->force, old + added);
    memset(model->force + old, 0, added * sizeof(double));
    return self;
}

void tinker_line_parts_free(TinkerLineParts *self)
{
    if (self == NULL) return;
    g_free(self->slots);
    g_free(self->incoming);
    g_free(self->targets);
    g_free(self);
}

static void clear(double *force, int32_t first, int32_t end)
{
    memset(force + 2 * (gsize)first, 0, 2 * (gsize)(end - first) * sizeof(double));
}

static void add_part(void *data, int32_t k)
{
    TinkerModel *model = data;
    TinkerLineParts *self = model->line_parts;
    const Part *part = &self->part[k];
    clear(model->force, part[0].first_point, part[1].first_point);
    clear(model->force, part[0].first_slot, part[1].first_slot);
    self->taken[k] = tinker_lines_add_range(&model->lines, self->slots, part[0].first_line, part[1].first_line,
                                            model->point, model->force);
}

static void add_incoming(void *data, int32_t k)
{
    const TinkerModel *model = data;
    const TinkerLineParts *self = model->line_parts;
    double *force = model->force;
    for (int32_t i = self->part[k].first_incoming; i < self->part[k + 1].first_incoming; i++) {
        const double *slot = force + 2 * (gsize)self->incoming[i];
        force[2 * (gsize)self->targets[i]] += slot[0];
        force[2 * (gsize)self->targets[i] + 1] += slot[1];
    }
}

double tinker_line_parts_forces(TinkerModel *model)
{
    const TinkerLineParts *self = model->line_parts;
    double taken = 0;
    tinker_share(self->count, add_part, model);
    for (int32_t k = 0; k < self->count; k++) {
        add_incoming(model, k);
        taken += self->taken[k];
    }
    return taken;
}
