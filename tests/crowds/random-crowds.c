/* Every body starts in a cell of its own of a grid, so that none overlap. */
#include "random-crowds.h"

#include <math.h>

#define FEWEST_BODIES 3
#define COLUMNS       4
#define ROWS          3
/* m: of a cell, and of the body in it at most, from its centre of mass. */
#define CELL  1.3
#define REACH 0.55

typedef struct {
    GRand *dice;
    GString *blocks;
    Crowd *crowd;
} Draft;

static double between(Draft *draft, double low, double high)
{
    return g_rand_double_range(draft->dice, low, high);
}

/* Walls ------------------------------------------------------------------------------------------------------------ */

/* A support whose top looks into the box, through the middle of one of its sides. Tops are longer than the sides, so
 * that the corners of the box are where tops cross. */
static void add_wall(Draft *draft, const char *name, double x, double y, double turn, double width)
{
    const double half = 0.2; /* of its height */
    const Crowd *crowd = draft->crowd;
    g_string_append_printf(draft->blocks,
                           "{'type': 'support', 'name': '%s', 'position': [%.17g, %.17g], 'orientation': %.17g, "
                           "'width': %.17g, 'restitution': %.17g, 'static_friction': %.17g, "
                           "'dynamic_friction': %.17g},\n",
                           name, x + half * sin(turn), y - half * cos(turn), turn, width + 2, crowd->restitution,
                           crowd->friction, crowd->friction);
}

static void add_walls(Draft *draft)
{
    const double w = draft->crowd->inside[0], h = draft->crowd->inside[1];
    add_wall(draft, "floor", 0.5 * w, 0, 0, w);
    add_wall(draft, "right", w, 0.5 * h, 0.5 * G_PI, h);
    add_wall(draft, "ceiling", 0.5 * w, h, G_PI, w);
    add_wall(draft, "left", 0, 0.5 * h, -0.5 * G_PI, h);
}

/* Shapes ----------------------------------------------------------------------------------------------------------- */

static void take_rectangle(CrowdPart *part, double left, double low, double right, double high)
{
    *part = (CrowdPart){4, {{left, low}, {right, low}, {right, high}, {left, high}}};
}

static void draw_disc(Draft *draft, CrowdBody *body)
{
    body->radius = between(draft, 0.15, 0.5);
    body->inertia = 0.5 * body->mass * body->radius * body->radius;
    body->part_count = 1;
    body->parts[0].corners = 0;
    g_string_append_printf(draft->blocks, "'type': 'disc', 'radius': %.17g", body->radius);
}

static void draw_box(Draft *draft, CrowdBody *body)
{
    const double width = between(draft, 0.2, 0.75), height = between(draft, 0.2, 0.75);
    body->radius = 0.5 * hypot(width, height);
    body->inertia = body->mass * (width * width + height * height) / 12;
    body->part_count = 1;
    take_rectangle(&body->parts[0], -0.5 * width, -0.5 * height, 0.5 * width, 0.5 * height);
    g_string_append_printf(draft->blocks, "'type': 'box', 'width': %.17g, 'height': %.17g", width, height);
}

/* Its centre of mass is where its axes are, and it has some inertia, whatever an even plate would have. */
static void write_plate(Draft *draft, CrowdBody *body, double (*outline)[2], int count)
{
    body->inertia = body->mass * pow(between(draft, 0.3, 0.6) * body->radius, 2);
    g_string_append(draft->blocks, "'type': 'plate', 'centre_of_mass': [0, 0], 'corners': [");
    for (int i = 0; i < count; i++)
        g_string_append_printf(draft->blocks, "%s[%.17g, %.17g]", i > 0 ? ", " : "", outline[i][0], outline[i][1]);
    g_string_append_printf(draft->blocks, "], 'inertia': %.17g", body->inertia);
}

/* Corners on a circle. */
static void draw_convex_plate(Draft *draft, CrowdBody *body)
{
    CrowdPart *part = &body->parts[0];
    body->radius = between(draft, 0.25, REACH);
    body->part_count = 1;
    part->corners = g_rand_int_range(draft->dice, 3, CROWD_MOST_CORNERS + 1);
    for (int i = 0; i < part->corners; i++) {
        const double angle = 2 * G_PI * (i + between(draft, -0.3, 0.3)) / part->corners;
        part->at[i][0] = body->radius * cos(angle);
        part->at[i][1] = body->radius * sin(angle);
    }
    write_plate(draft, body, part->at, part->corners);
}

/* An L about its inner corner, its legs of any length and thickness. */
static void draw_angle_plate(Draft *draft, CrowdBody *body)
{
    const double thick = between(draft, 0.1, 0.25), right = between(draft, 0.15, 0.35), up = between(draft, 0.15, 0.35);
    double outline[][2] = {{-thick, -thick}, {right, -thick}, {right, 0}, {0, 0}, {0, up}, {-thick, up}};
    body->radius = hypot(fmax(right, up), thick);
    body->part_count = 2;
    take_rectangle(&body->parts[0], -thick, -thick, right, 0);
    take_rectangle(&body->parts[1], -thick, -thick, 0, up);
    write_plate(draft, body, outline, G_N_ELEMENTS(outline));
}

static void (*const shapes[])(Draft *, CrowdBody *) = {draw_disc, draw_box, draw_convex_plate, draw_angle_plate};

static void add_body(Draft *draft, int number, int cell)
{
    CrowdBody *body = &draft->crowd->bodies[number];
    const double x = CELL * (cell % COLUMNS + 0.5), y = CELL * (cell / COLUMNS + 0.5);
    const int shape = g_rand_int_range(draft->dice, 0, (gint32)G_N_ELEMENTS(shapes));
    body->mass = between(draft, 0.3, 3);
    g_string_append_printf(draft->blocks, "{'name': 'b%d', ", number);
    shapes[shape](draft, body);
    const double angle = between(draft, -3, 3), vx = between(draft, -3, 3), vy = between(draft, -3, 3),
                 rate = between(draft, -5, 5);
    g_string_append_printf(draft->blocks,
                           ", 'mass': %.17g, 'position': [%.17g, %.17g], 'orientation': %.17g, 'velocity': [%.17g, "
                           "%.17g], 'angular_velocity': %.17g, 'restitution': %.17g, 'static_friction': %.17g, "
                           "'dynamic_friction': %.17g},\n",
                           body->mass, x, y, angle, vx, vy, rate, draft->crowd->restitution, draft->crowd->friction,
                           draft->crowd->friction);
}

/* Into cells that are drawn without putting one back. */
static void add_bodies(Draft *draft)
{
    int cells[COLUMNS * ROWS];
    for (int i = 0; i < COLUMNS * ROWS; i++)
        cells[i] = i;
    for (int i = 0; i < draft->crowd->count; i++) {
        const int other = g_rand_int_range(draft->dice, i, COLUMNS * ROWS), cell = cells[other];
        cells[other] = cells[i];
        cells[i] = cell;
        add_body(draft, i, cell);
    }
}

Crowd *crowd_new(guint32 seed, int most)
{
    Crowd *crowd = g_new0(Crowd, 1);
    g_autoptr(GRand) dice = g_rand_new_with_seed(seed);
    g_autoptr(GString) blocks = g_string_new(NULL);
    Draft draft = {dice, blocks, crowd};
    crowd->count = g_rand_int_range(dice, FEWEST_BODIES, most + 1);
    crowd->inside[0] = CELL * COLUMNS;
    crowd->inside[1] = CELL * ROWS;
    crowd->duration = between(&draft, 2, 5);
    crowd->friction = g_rand_double(dice) < 0.2 ? 0 : between(&draft, 0, 0.6);
    crowd->restitution = g_rand_double(dice) < 0.2 ? 0 : between(&draft, 0, 0.9);
    crowd->gravity = g_rand_double(dice) < 0.2 ? 0 : 9.81;
    add_walls(&draft);
    add_bodies(&draft);
    g_string_append_printf(blocks, "{'type': 'gravity', 'name': 'gravity', 'acceleration': %.17g}", crowd->gravity);
    crowd->text = g_strdup_printf("{\"tinker\": 1, \"run\": {\"duration\": %.17g}, \"blocks\": [\n%s]}\n",
                                  crowd->duration, blocks->str);
    g_strdelimit(crowd->text, "'", '"');
    return crowd;
}

void crowd_free(Crowd *crowd)
{
    if (crowd == NULL) return;
    g_free(crowd->text);
    g_free(crowd);
}
