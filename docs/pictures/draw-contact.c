/* Draws the pictures of docs/contact.md: draw-contact FOLDER writes contact-*.png, with the brush that scenes are drawn
 * with. Lengths are in m, 100 pixels each, from the lower left corner of a picture. */
#include <glib.h>
#include <math.h>
#include <stdio.h>

#include "render/draw/surface.h"
#include "render/picture/note.h"
#include "sketch.h"

#define SCALE  100.0 /* pixels per m */
#define SYMBOL 0.16  /* m: arrow heads */
#define TOP    1.0   /* m: where floors are */

typedef struct {
    const char *name;
    double width, height; /* m */
    void (*draw)(const Sketch *sketch);
} Picture;

/* A mass over a top: half its height stands off, whatever its place. */
static void draw_mass(const Sketch *s)
{
    const double angle = -G_PI / 9.0, c = cos(angle), sn = sin(angle), x = 0.5, y = 2.4;
    const double along = 2.0, high = 1.25, half = 0.45;
    const double foot[] = {x + along * c, y + along * sn}, centre[] = {foot[0] - high * sn, foot[1] + high * c};
    sketch_slab(s, x, y, 5.2, angle);
    sketch_box(s, centre[0], centre[1], 1.0, 2.0 * half, angle);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, centre[0], centre[1]);
    sketch_dashed(s, centre[0], centre[1], foot[0], foot[1]);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, foot[0], foot[1]);
    sketch_note(s, TINKER_COLOUR_TEXT, foot[0] - 0.25, foot[1] + 0.25, "foot");
    const double off[] = {0.75 * c, 0.75 * sn};
    const double low = high - half;
    sketch_measure(s, centre[0] + off[0], centre[1] + off[1], foot[0] + off[0] - low * sn, foot[1] + off[1] + low * c);
    sketch_measure(s, foot[0] + off[0] - low * sn, foot[1] + off[1] + low * c, foot[0] + off[0], foot[1] + off[1]);
    sketch_note(s, TINKER_COLOUR_COMPRESSED, centre[0] + 1.4, centre[1] - 0.3, "height / 2");
    sketch_note(s, TINKER_COLOUR_COMPRESSED, foot[0] + 1.25, foot[1] + 0.2, "gap");
    sketch_axes(s, x + 4.0 * c, y + 4.0 * sn, angle);
    sketch_note(s, TINKER_COLOUR_TEXT, x + 0.55, y + 0.05, "top");
    sketch_note(s, TINKER_COLOUR_TEXT, 2.6, 4.15, "mass: a point, drawn as a box");
}

/* A disc over an edge, a disc over a corner, a corner over an edge. */
static void draw_shapes(const Sketch *s)
{
    const double radius = 0.6, gap = 0.45;
    sketch_slab(s, 0.4, TOP, 2.2, 0.0);
    sketch_disc(s, 1.5, TOP + gap + radius, radius);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, 1.5, TOP + gap + radius);
    sketch_measure(s, 1.5, TOP, 1.5, TOP + gap);
    sketch_note(s, TINKER_COLOUR_COMPRESSED, 1.8, TOP + 0.5 * gap, "gap");
    sketch_axes(s, 0.7, TOP, 0.0);
    sketch_note(s, TINKER_COLOUR_TEXT, 1.5, 0.35, "disc over an edge\n$gap = n*(c - e) - R$");

    const double corner[] = {4.5, TOP + 0.1}, centre[] = {5.2, TOP + 0.95};
    const double far = hypot(centre[0] - corner[0], centre[1] - corner[1]);
    const double n[] = {(centre[0] - corner[0]) / far, (centre[1] - corner[1]) / far};
    sketch_slab(s, 3.2, corner[1], corner[0] - 3.2, 0.0);
    sketch_line(s, TINKER_COLOUR_BODY_EDGE, corner[0], corner[1], corner[0], corner[1] - 0.3);
    sketch_disc(s, centre[0], centre[1], radius);
    sketch_dashed(s, corner[0] + (far - radius) * n[0], corner[1] + (far - radius) * n[1], centre[0], centre[1]);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, centre[0], centre[1]);
    sketch_measure(s, corner[0], corner[1], corner[0] + (far - radius) * n[0], corner[1] + (far - radius) * n[1]);
    sketch_note(s, TINKER_COLOUR_COMPRESSED, 5.05, TOP + 0.15, "gap");
    sketch_axes(s, 3.9, corner[1], atan2(n[1], n[0]) - G_PI / 2.0);
    sketch_note(s, TINKER_COLOUR_TEXT, 4.6, 0.35, "disc over a corner\n$gap = abs(c - p) - R$");

    const double turned = 0.5, half[] = {0.55, 0.4}, place[] = {7.8, TOP + gap};
    sketch_slab(s, 6.6, TOP, 2.2, 0.0);
    sketch_box(s, place[0] + half[0] * cos(turned) - half[1] * sin(turned),
               place[1] + half[0] * sin(turned) + half[1] * cos(turned), 2.0 * half[0], 2.0 * half[1], turned);
    sketch_measure(s, place[0], TOP, place[0], place[1]);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, place[0], place[1]);
    sketch_note(s, TINKER_COLOUR_COMPRESSED, place[0] + 0.3, TOP + 0.45 * gap, "gap");
    sketch_axes(s, 6.9, TOP, 0.0);
    sketch_note(s, TINKER_COLOUR_TEXT, 7.7, 0.35, "corner over an edge\n$gap = n*(p - e)$");
}

/* What comes to lie flat has a gap at each corner, and then a force at each. */
static void draw_two_points(const Sketch *s)
{
    const double turned = 0.16, wide = 1.6, high = 1.2, low = 0.25;
    const double corner[] = {0.9, TOP + low};
    sketch_slab(s, 0.4, TOP, 2.8, 0.0);
    sketch_box(s, corner[0] + 0.5 * wide * cos(turned) - 0.5 * high * sin(turned),
               corner[1] + 0.5 * wide * sin(turned) + 0.5 * high * cos(turned), wide, high, turned);
    const double other[] = {corner[0] + wide * cos(turned), corner[1] + wide * sin(turned)};
    sketch_measure(s, corner[0], TOP, corner[0], corner[1]);
    sketch_measure(s, other[0], TOP, other[0], other[1]);
    sketch_note(s, TINKER_COLOUR_COMPRESSED, corner[0] - 0.25, TOP + 0.5 * low, "$g_1$");
    sketch_note(s, TINKER_COLOUR_COMPRESSED, other[0] + 0.25, TOP + 0.2, "$g_2$");
    sketch_note(s, TINKER_COLOUR_TEXT, 1.8, 0.35, "two corners, two gaps");

    sketch_slab(s, 4.0, TOP, 2.8, 0.0);
    sketch_box(s, 5.4, TOP + 0.5 * high, wide, high, 0.0);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, 5.6, TOP + 0.5 * high);
    sketch_arrow(s, TINKER_COLOUR_FIELD, 5.6, TOP + 0.5 * high, 0.0, -0.56);
    sketch_note(s, TINKER_COLOUR_FIELD, 5.86, TOP + 0.2, "$m*g$");
    sketch_arrow(s, TINKER_COLOUR_FORCE, 5.4 - 0.5 * wide, TOP, 0.0, 0.21);
    sketch_arrow(s, TINKER_COLOUR_FORCE, 5.4 + 0.5 * wide, TOP, 0.0, 0.35);
    sketch_note(s, TINKER_COLOUR_FORCE, 5.15 - 0.5 * wide, TOP + 0.2, "$N_1$");
    sketch_note(s, TINKER_COLOUR_FORCE, 5.65 + 0.5 * wide, TOP + 0.35, "$N_2$");
    sketch_note(s, TINKER_COLOUR_TEXT, 5.4, 0.35, "flat: two forces");
}

/* The forces that a contact can give, as a wedge about its normal. */
static void draw_cone(const Sketch *s)
{
    const double friction = 0.5, high = 2.0, places[] = {1.9, 5.4};
    for (int i = 0; i < 2; i++) {
        const double x = places[i],
                     wedge[] = {x, TOP, x - friction * high, TOP + high, x + friction * high, TOP + high};
        sketch_slab(s, x - 1.4, TOP, 2.8, 0.0);
        s->style->polygon(s->style, s->cairo, TINKER_COLOUR_BODY, -1, wedge, 3);
        sketch_dashed(s, x, TOP, x - friction * high, TOP + high);
        sketch_dashed(s, x, TOP, x + friction * high, TOP + high);
        sketch_dashed(s, x, TOP, x, TOP + high);
        const double across = i == 0 ? 0.3 : -friction * 1.5;
        sketch_arrow(s, TINKER_COLOUR_FORCE, x, TOP, across, 1.5);
        sketch_dashed(s, x + across, TOP + 1.5, x, TOP + 1.5);
        sketch_note(s, TINKER_COLOUR_TEXT, x - copysign(0.14, across), TOP + 1.0, "$N$");
        sketch_note(s, TINKER_COLOUR_TEXT, x + 0.5 * across, TOP + 1.63, "$f$");
        sketch_note(s, TINKER_COLOUR_TEXT, x + 1.45, TOP + high - 0.1, "$atan(mu)$");
        sketch_dot(s, TINKER_COLOUR_BODY_EDGE, x, TOP);
    }
    sketch_arrow(s, TINKER_COLOUR_MOTION, places[1] + 0.2, TOP + 0.12, 0.9, 0.0);
    sketch_note(s, TINKER_COLOUR_MOTION, places[1] + 1.3, TOP + 0.14, "$u_t$");
    sketch_note(s, TINKER_COLOUR_TEXT, places[0], 0.35, "sticks: the force lies within\n$abs(f) <= mu_s*N$");
    sketch_note(s, TINKER_COLOUR_TEXT, places[1], 0.35,
                "slips: it lies on the edge,\n$abs(f) = mu_d*N$, against $u_t$");
}

/* A wheel whose point of contact is at rest; boxes pushed high and low, with all forces that act on them. */
static void draw_kinds(const Sketch *s)
{
    const double radius = 0.7, rolling = 1.5, speed = 0.6;
    sketch_slab(s, 0.3, TOP, 2.4, 0.0);
    sketch_disc(s, rolling, TOP + radius, radius);
    sketch_arrow(s, TINKER_COLOUR_MOTION, rolling, TOP + radius, speed, 0.0);
    sketch_arrow(s, TINKER_COLOUR_MOTION, rolling, TOP + 2.0 * radius, 2.0 * speed, 0.0);
    sketch_dashed(s, rolling, TOP, rolling, TOP + 2.0 * radius);
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, rolling, TOP);
    sketch_note(s, TINKER_COLOUR_MOTION, rolling + 0.45, TOP + radius + 0.15, "$v$");
    sketch_note(s, TINKER_COLOUR_MOTION, rolling + 0.9, TOP + 2.0 * radius + 0.15, "$2*v$");
    sketch_note(s, TINKER_COLOUR_TEXT, rolling, 0.35, "rolls: the point that\ntouches sticks, $v = omega*R$");

    const double wide = 0.9, high = 1.4, weight = 0.65, turned = -0.12, corner = 5.0;
    const double centre[] = {corner - 0.5 * wide * cos(turned) - 0.5 * high * sin(turned),
                             TOP - 0.5 * wide * sin(turned) + 0.5 * high * cos(turned)};
    sketch_slab(s, 3.4, TOP, 2.4, 0.0);
    sketch_box(s, centre[0], centre[1], wide, high, turned);
    sketch_arrow(s, TINKER_COLOUR_FIELD, centre[0], centre[1], 0.0, -weight);
    sketch_note(s, TINKER_COLOUR_FIELD, centre[0] - 0.26, centre[1] - 0.25, "$m*g$");
    const double pushed[] = {centre[0] - 0.5 * wide * cos(turned) - 0.4 * high * sin(turned),
                             centre[1] - 0.5 * wide * sin(turned) + 0.4 * high * cos(turned)};
    sketch_arrow(s, TINKER_COLOUR_FORCE, pushed[0] - 0.45, pushed[1], 0.45, 0.0);
    sketch_note(s, TINKER_COLOUR_FORCE, pushed[0] - 0.55, pushed[1] + 0.18, "$P$");
    sketch_arrow(s, TINKER_COLOUR_FORCE, corner, TOP, 0.0, weight);
    sketch_arrow(s, TINKER_COLOUR_FORCE, corner, TOP, -0.45, 0.0);
    sketch_note(s, TINKER_COLOUR_FORCE, corner + 0.2, TOP + weight - 0.1, "$N$");
    sketch_note(s, TINKER_COLOUR_FORCE, corner - 0.17, TOP + 0.14, "$f$");
    sketch_dot(s, TINKER_COLOUR_BODY_EDGE, corner, TOP);
    sketch_note(s, TINKER_COLOUR_TEXT, 4.6, 0.35, "tips about a corner:\n$P*h > m*g*w/2$");

    /* What presses stands off the middle, so that its moment balances those of P and f. */
    const double slides = 7.7, push = 0.6, at = 0.35, rubs = 0.4;
    const double off = (0.5 * high * rubs - (0.5 * high - at) * push) / weight;
    sketch_slab(s, 6.5, TOP, 2.4, 0.0);
    sketch_box(s, slides, TOP + 0.5 * high, wide, high, 0.0);
    sketch_arrow(s, TINKER_COLOUR_FIELD, slides, TOP + 0.5 * high, 0.0, -weight);
    sketch_note(s, TINKER_COLOUR_FIELD, slides - 0.24, TOP + 0.4, "$m*g$");
    sketch_arrow(s, TINKER_COLOUR_FORCE, slides - 0.5 * wide - push, TOP + at, push, 0.0);
    sketch_note(s, TINKER_COLOUR_FORCE, slides - 0.5 * wide - push, TOP + at + 0.18, "$P$");
    sketch_arrow(s, TINKER_COLOUR_FORCE, slides + off, TOP, 0.0, weight);
    sketch_arrow(s, TINKER_COLOUR_FORCE, slides + off, TOP, -rubs, 0.0);
    sketch_note(s, TINKER_COLOUR_FORCE, slides + off + 0.13, TOP + 0.13, "$f$");
    sketch_note(s, TINKER_COLOUR_FORCE, slides + off + 0.16, TOP + weight, "$N$");
    sketch_arrow(s, TINKER_COLOUR_MOTION, slides + 0.55, TOP + high - 0.2, 0.5, 0.0);
    sketch_note(s, TINKER_COLOUR_MOTION, slides + 0.75, TOP + high, "$v$");
    sketch_note(s, TINKER_COLOUR_TEXT, slides, 0.35, "slides:\n$P > mu_s*m*g$");
}

/* Three equal elastic balls in a row, of which the first comes with v; velocities behind the blow by each law. */
static void draw_laws(const Sketch *s)
{
    static const struct {
        const char *title;
        double velocities[3]; /* over v */
        const char *labels[3];
    } rows[] = {
        {"before", {1.0, 0.0, 0.0}, {"$v$", "$0$", "$0$"}},
        {"newton, poisson", {-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0}, {"$-v/3$", "$2/3*v$", "$2/3*v$"}},
        {"sequential", {0.0, 0.0, 1.0}, {"$0$", "$0$", "$v$"}},
    };
    const double radius = 0.3, unit = 0.9;
    for (int row = 0; row < 3; row++) {
        const double y = 3.0 - 1.15 * row;
        sketch_note(s, TINKER_COLOUR_TEXT, 1.0, y, rows[row].title);
        for (int ball = 0; ball < 3; ball++) {
            const double v = rows[row].velocities[ball], x = 3.6 + ball * 1.3 - (row == 0 && ball == 0 ? 0.6 : 0.0) +
                                                             (row == 0 && ball == 2 ? 2.0 * radius - 1.3 : 0.0);
            sketch_disc(s, x, y, radius);
            if (v != 0.0) sketch_arrow(s, TINKER_COLOUR_MOTION, x, y, unit * v, 0.0);
            sketch_note(s, v != 0.0 ? TINKER_COLOUR_MOTION : TINKER_COLOUR_TEXT, x, y + 0.48, rows[row].labels[ball]);
        }
    }
}

static const Picture pictures[] = {
    {"contact-mass", 6.2, 4.4, draw_mass},
    {"contact-shapes", 9.2, 2.9, draw_shapes},
    {"contact-two-points", 7.4, 2.7, draw_two_points},
    {"contact-cone", 7.6, 3.2, draw_cone},
    {"contact-kinds", 9.2, 2.9, draw_kinds},
    {"contact-laws", 7.6, 3.8, draw_laws},
};

static void draw_picture(cairo_t *cairo, double width, double height, gpointer data)
{
    const Picture *picture = data;
    const TinkerTheme *theme = tinker_theme_find("light");
    const TinkerView view = {.scale = SCALE, .origin_y = height, .width = width, .height = height};
    cairo_set_source_rgb(cairo, theme->background[0], theme->background[1], theme->background[2]);
    cairo_paint(cairo);
    TinkerStyleBrush brush;
    tinker_style_begin(&brush, cairo, theme, &view, SYMBOL);
    brush.style.note = tinker_note_draw;
    tinker_style_enter_world(&brush.style, cairo);
    picture->draw(&(Sketch){.cairo = cairo, .style = &brush.style});
    cairo_restore(cairo);
    tinker_style_end(&brush);
}

int main(int argc, char **argv)
{
    g_autoptr(GError) error = NULL;
    if (argc != 2) {
        fprintf(stderr, "usage: draw-contact FOLDER\n");
        return 2;
    }
    gboolean drawn = TRUE;
    for (gsize i = 0; drawn && i < G_N_ELEMENTS(pictures); i++) {
        Picture picture = pictures[i];
        g_autofree char *path = g_strdup_printf("%s/%s.png", argv[1], picture.name);
        drawn = tinker_surface_to_file(draw_picture, &picture, (int)lround(SCALE * picture.width),
                                       (int)lround(SCALE * picture.height), path, &error);
    }
    if (!drawn) fprintf(stderr, "draw-contact: %s\n", error->message);
    return drawn ? 0 : 1;
}
