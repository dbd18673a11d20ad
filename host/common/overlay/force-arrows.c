/* Arrows, each with what it comes from or what it is and how large it is, and the key: alike in the window, in pictures
 * and in films. */
#include "common/overlay/force-arrows.h"

#include <glib/gi18n.h>
#include <math.h>

#include "render/draw/text.h"
#include "render/picture/painter.h"

/* No unit; of the longer side of a picture: what is longer is no arrow to compare with others. */
#define LONGEST_SHARE 0.5

#define INWARD 0.3  /* cosine of the angle between what pushes and the way to the centre */
#define SMALL  48.0 /* canvas units: a body that a label would hide, or most of it */
#define MOST_CLEAR                                                                                                     \
    12 /* arrows: of more, labels are not looked farther off for a place where they cover nothing, which */
#define CLEAR_REACH 120.0 /* canvas units: takes its time; and how far */
#define MOST_BLOCKS 1000  /* of a scene, before labels hide bodies, since looking for these would take long */

double tinker_force_arrows_greatest(const GArray *acting)
{
    double greatest = 0;
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        greatest = fmax(greatest, hypot(force->fx, force->fy));
    }
    return greatest;
}

gboolean tinker_force_arrows_any(const GArray *acting)
{
    return tinker_force_arrows_greatest(acting) > 0;
}

gboolean tinker_force_arrows_outgrow(const GArray *acting, const TinkerView *view, double pixels)
{
    return pixels * tinker_force_arrows_greatest(acting) > LONGEST_SHARE * fmax(view->width, view->height);
}

double tinker_force_arrows_scale(const GArray *acting, const TinkerView *view, double previous)
{
    g_autoptr(GArray) arrows = g_array_new(FALSE, TRUE, sizeof(TinkerForceArrow));
    for (guint i = 0; i < acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(acting, TinkerActingForce, i);
        g_array_append_val(arrows, ((TinkerForceArrow){.fx = force->fx, .fy = force->fy}));
    }
    return view->scale * tinker_arrows_scale((const TinkerForceArrow *)(gpointer)arrows->data, arrows->len, view,
                                             previous / view->scale);
}

static const struct {
    TinkerActingKind acting;
    TinkerArrowKind arrow;
    const char *word;
} kinds[] = {
    {TINKER_ACTING_FIELD, TINKER_ARROW_FIELD, N_("Field")},
    {TINKER_ACTING_NORMAL, TINKER_ARROW_NORMAL, N_("Normal force")},
    {TINKER_ACTING_FRICTION, TINKER_ARROW_FRICTION, N_("Friction")},
    {TINKER_ACTING_LINE, TINKER_ARROW_CONNECTOR, N_("Connector")},
    {TINKER_ACTING_CONSTRAINT, TINKER_ARROW_CONSTRAINT, N_("Constraint")},
    {TINKER_ACTING_ELEMENT, TINKER_ARROW_APPLIED, N_("Applied force")},
};

/* By its place in the list, whose last is what all others are. */
static gsize kind_of(TinkerActingKind acting)
{
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(kinds) && kinds[i].acting != acting)
        i++;
    return i;
}

const char *tinker_force_arrow_word(TinkerArrowKind kind)
{
    gsize i = 0;
    while (i + 1 < G_N_ELEMENTS(kinds) && kinds[i].arrow != kind)
        i++;
    return _(kinds[i].word);
}

gboolean tinker_force_arrow_pushes(const TinkerFrame *frame, TinkerBlockId on, const double point[2],
                                   const double force[2])
{
    double x, y, orientation;
    tinker_frame_centre(frame, on, &x, &y, &orientation);
    const double inward = force[0] * (x - point[0]) + force[1] * (y - point[1]);
    return inward > INWARD * hypot(force[0], force[1]) * hypot(x - point[0], y - point[1]);
}

static char *label_of(TinkerScene *scene, const TinkerActingForce *force)
{
    static const TinkerDimension dimension = TINKER_DIMENSION_FORCE;
    g_autofree char *value =
        tinker_quantity_format(hypot(force->fx, force->fy), dimension, NULL, tinker_scene_head(scene)->units, 2);
    gboolean contact = force->kind == TINKER_ACTING_NORMAL || force->kind == TINKER_ACTING_FRICTION;
    const char *by = tinker_scene_block_name(scene, force->by);
    return contact ? g_strdup_printf("%s (%s) %s", by, _(kinds[kind_of(force->kind)].word), value)
                   : g_strdup_printf("%s %s", by, value);
}

/* One row of the key: how long a round value is. */
typedef struct {
    double pixels; /* canvas units per SI unit; 0: there is no such scale */
    TinkerDimension dimension;
    const double *colour;
} Scale;

/* Fills `length`, whose label is added to `labels`. FALSE where the scale is not known. */
static gboolean key_length(const Scale *scale, const TinkerView *view, TinkerUnitSystem system, GPtrArray *labels,
                           TinkerArrowLength *length)
{
    TinkerUnit unit = {.factor = 1};
    tinker_unit_parse(tinker_unit_for(scale->dimension, system), &unit, NULL);
    const double value = tinker_arrows_key_value(view, scale->pixels / view->scale, unit.factor);
    if (!(scale->pixels > 0) || !(value > 0)) return FALSE;
    g_ptr_array_add(labels, tinker_quantity_brief(value, scale->dimension, system));
    *length = (TinkerArrowLength){value * scale->pixels, labels->pdata[labels->len - 1], scale->colour};
    return TRUE;
}

static gboolean is_shown(const TinkerForceArrow *arrow)
{
    return hypot(arrow->fx, arrow->fy) > 0;
}

static guint count_shown(const GArray *arrows)
{
    guint count = 0;
    for (guint i = 0; i < arrows->len; i++)
        count += is_shown(&g_array_index(arrows, TinkerForceArrow, i));
    return count;
}

static gboolean has_kind(const GArray *arrows, TinkerArrowKind kind)
{
    gboolean found = FALSE;
    for (guint i = 0; i < arrows->len && !found; i++) {
        const TinkerForceArrow *arrow = &g_array_index(arrows, TinkerForceArrow, i);
        found = arrow->kind == kind && is_shown(arrow);
    }
    return found;
}

/* A key, and what it points to. */
typedef struct {
    TinkerArrowKey key;
    TinkerArrowWord words[G_N_ELEMENTS(kinds) + TINKER_VECTOR_KINDS];
    TinkerArrowLength lengths[TINKER_VECTOR_KINDS];
    GPtrArray *labels; /* of char * */
} Key;

/* Of the kinds that there are now, and how long a round value of each scale is. */
static void key_init(Key *key, const TinkerForceArrows *forces, const TinkerView *view, const GArray *arrows,
                     const TinkerTheme *theme)
{
    const TinkerUnitSystem system = tinker_scene_head(forces->scene)->units;
    gsize words = 0, lengths = 0;
    gboolean has_force = FALSE;
    key->labels = g_ptr_array_new_with_free_func(g_free);
    for (gsize k = 0; k < G_N_ELEMENTS(kinds); k++) {
        if (!has_kind(arrows, kinds[k].arrow)) continue;
        key->words[words++] = (TinkerArrowWord){kinds[k].arrow, _(kinds[k].word)};
        has_force = TRUE;
    }
    const Scale of_forces = {forces->pixels, TINKER_DIMENSION_FORCE, NULL};
    const gboolean needs_force = has_force || has_kind(arrows, TINKER_ARROW_NET) || forces->vectors == NULL;
    if (needs_force && key_length(&of_forces, view, system, key->labels, &key->lengths[lengths])) lengths++;
    for (int k = 0; k < TINKER_VECTOR_KINDS; k++) {
        const TinkerVectorLook *look = tinker_vector_look(k);
        const double pixels = k == TINKER_VECTOR_NET_FORCE ? 0 : forces->vector_pixels[k];
        const Scale scale = {pixels, look->dimension, tinker_arrow_colour(theme, look->arrow)};
        if (!has_kind(arrows, look->arrow)) continue;
        key->words[words++] = (TinkerArrowWord){look->arrow, _(look->word)};
        if (key_length(&scale, view, system, key->labels, &key->lengths[lengths])) lengths++;
    }
    key->key = (TinkerArrowKey){key->lengths, lengths, forces->marks, key->words, words};
}

/* Labels cover no small body, and others where there is no other way. */
static void take_bodies(const TinkerForceArrows *forces, const TinkerView *view, GArray *taken, GArray *drawn)
{
    const int32_t count = forces->frame != NULL ? tinker_scene_block_count(forces->scene) : 0;
    for (int32_t i = 0; i < count && count <= MOST_BLOCKS; i++) {
        const TinkerBlockId block = tinker_scene_block_at(forces->scene, i);
        double world[4], box[4];
        if (!tinker_block_moves(forces->scene, block) || !tinker_painter_box(forces->frame, block, view, world))
            continue;
        tinker_view_to_canvas(view, world[0], world[3], &box[0], &box[1]);
        tinker_view_to_canvas(view, world[2], world[1], &box[2], &box[3]);
        g_array_append_vals(fmax(box[2] - box[0], box[3] - box[1]) < SMALL ? taken : drawn, box, 1);
    }
}

/* Boxes that labels keep clear of: of texts, of small bodies, and of the key; of other bodies into `drawn`. Of
 * double[4]. (transfer full) */
static GArray *taken_boxes(const TinkerForceArrows *forces, const Key *key, const TinkerView *view,
                           const TinkerTheme *theme, GArray *drawn)
{
    GArray *taken = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    double box[4];
    for (guint i = 0; forces->texts != NULL && i < forces->texts->len; i++)
        g_array_append_vals(taken, ((const TinkerWrittenText *)g_ptr_array_index(forces->texts, i))->box, 1);
    take_bodies(forces, view, taken, drawn);
    if (tinker_arrows_key_box(view, theme, &key->key, box)) g_array_append_vals(taken, box, 1);
    return taken;
}

static TinkerPointed pointed_of(const TinkerActingForce *force)
{
    const TinkerPointedPart part = force->kind == TINKER_ACTING_NORMAL     ? TINKER_POINTED_NORMAL
                                   : force->kind == TINKER_ACTING_FRICTION ? TINKER_POINTED_FRICTION
                                                                           : TINKER_POINTED_WHOLE;
    return (TinkerPointed){force->by, force->on, part};
}

/* By a block, or on one; of a single force that alone. */
static gboolean is_lit(const TinkerForceArrows *forces, const TinkerActingForce *force)
{
    const TinkerPointed thing = pointed_of(force);
    if (forces->lit == NULL || forces->lit->block == TINKER_NO_BLOCK) return FALSE;
    const gboolean on_it = !tinker_pointed_is_force(forces->lit) && force->on == forces->lit->block;
    return on_it || tinker_pointed_lights(forces->lit, &thing);
}

static gboolean any_is_lit(const TinkerForceArrows *forces)
{
    for (guint i = 0; i < forces->acting->len; i++)
        if (is_lit(forces, &g_array_index(forces->acting, TinkerActingForce, i))) return TRUE;
    return FALSE;
}

/* Lengths are canvas units from here on, since vectors have scales of their own. */
static void add_forces(const TinkerForceArrows *forces, GArray *arrows, GPtrArray *labels, GArray *things)
{
    const gboolean some_lit = any_is_lit(forces);
    for (guint i = 0; forces->pixels > 0 && i < forces->acting->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces->acting, TinkerActingForce, i);
        char *label = label_of(forces->scene, force);
        g_ptr_array_add(labels, label);
        TinkerForceArrow arrow = {.x = force->x,
                                  .y = force->y,
                                  .fx = forces->pixels * force->fx,
                                  .fy = forces->pixels * force->fy,
                                  .label = label,
                                  .kind = kinds[kind_of(force->kind)].arrow};
        const double point[] = {force->x, force->y}, load[] = {force->fx, force->fy};
        if (forces->frame != NULL && tinker_force_arrow_pushes(forces->frame, force->on, point, load))
            arrow.look |= TINKER_ARROW_PUSHES;
        if (some_lit && !is_lit(forces, force)) arrow.look |= TINKER_ARROW_FADED;
        const TinkerPointed thing = pointed_of(force);
        g_array_append_val(arrows, arrow);
        g_array_append_val(things, thing);
    }
}

/* They light up their body. */
static void add_vectors(const TinkerForceArrows *forces, GArray *arrows, GPtrArray *labels, GArray *things)
{
    const TinkerUnitSystem system = tinker_scene_head(forces->scene)->units;
    for (guint i = 0; forces->vectors != NULL && i < forces->vectors->len; i++) {
        const TinkerMotionVector *vector = &g_array_index(forces->vectors, TinkerMotionVector, i);
        const TinkerVectorLook *look = tinker_vector_look(vector->kind);
        const double pixels =
            vector->kind == TINKER_VECTOR_NET_FORCE ? forces->pixels : forces->vector_pixels[vector->kind];
        if (!(pixels > 0)) continue;
        g_autofree char *value =
            tinker_quantity_format(hypot(vector->value_x, vector->value_y), look->dimension, NULL, system, 2);
        char *label = g_strdup_printf("%s %s", look->sign, value);
        g_ptr_array_add(labels, label);
        const TinkerForceArrow arrow = {.x = vector->x,
                                        .y = vector->y,
                                        .fx = pixels * vector->value_x,
                                        .fy = pixels * vector->value_y,
                                        .label = label,
                                        .kind = look->arrow};
        const TinkerPointed thing = tinker_pointed_block(vector->of);
        g_array_append_val(arrows, arrow);
        g_array_append_val(things, thing);
    }
}

/* Where what lies. */
static void add_spots(const TinkerForceArrows *forces, const GArray *arrows, const GArray *things, const GArray *places)
{
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        const TinkerPointed thing = g_array_index(things, TinkerPointed, place->number);
        const char *label = g_array_index(arrows, TinkerForceArrow, place->number).label;
        tinker_spots_add_line(forces->spots, place->shaft, thing, label);
        if (place->label[2] > place->label[0]) tinker_spots_add_box(forces->spots, place->label, thing, label);
    }
}

void tinker_force_arrows_draw(const TinkerForceArrows *forces, cairo_t *cairo, const TinkerView *view,
                              const TinkerTheme *theme)
{
    g_autoptr(GPtrArray) labels = g_ptr_array_new_with_free_func(g_free);
    g_autoptr(GArray) arrows = g_array_new(FALSE, FALSE, sizeof(TinkerForceArrow));
    g_autoptr(GArray) things = g_array_new(FALSE, FALSE, sizeof(TinkerPointed));
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    add_forces(forces, arrows, labels, things);
    add_vectors(forces, arrows, labels, things);
    Key key;
    key_init(&key, forces, view, arrows, theme);
    g_autoptr(GArray) drawn = g_array_new(FALSE, FALSE, 4 * sizeof(double));
    g_autoptr(GArray) taken = taken_boxes(forces, &key, view, theme, drawn);
    const TinkerArrowOptions options = {.theme = theme,
                                        .scale = 1 / view->scale,
                                        .taken = (const double(*)[4])(gpointer)taken->data,
                                        .taken_count = (int)taken->len,
                                        .drawn = (const double(*)[4])(gpointer)drawn->data,
                                        .drawn_count = (int)drawn->len,
                                        .roomy = count_shown(arrows) <= MOST_CLEAR,
                                        .reach = CLEAR_REACH,
                                        .places = forces->spots != NULL ? places : NULL};
    tinker_arrows_draw(cairo, view, (const TinkerForceArrow *)(gpointer)arrows->data, arrows->len, &options);
    add_spots(forces, arrows, things, places);
    tinker_arrows_draw_key(cairo, view, theme, &key.key, NULL);
    g_ptr_array_unref(key.labels);
}

gboolean tinker_force_acts_on_moving(TinkerScene *scene, const TinkerActingForce *force)
{
    return tinker_block_moves(scene, force->on);
}

void tinker_force_arrows_keep_moving(TinkerScene *scene, GArray *acting)
{
    for (guint i = acting->len; i-- > 0;)
        if (!tinker_force_acts_on_moving(scene, &g_array_index(acting, TinkerActingForce, i)))
            g_array_remove_index(acting, i);
}

/* Over a picture --------------------------------------------------------------------------------------------------- */

void tinker_force_arrows_over(cairo_t *cairo, const TinkerView *view, const TinkerTheme *theme, void *data)
{
    TinkerForceArrows *forces = data;
    const GArray *known =
        forces->at_start != NULL && tinker_force_arrows_any(forces->at_start) ? forces->at_start : forces->acting;
    double greatest[TINKER_VECTOR_KINDS] = {0};
    if (!(forces->pixels > 0) && tinker_force_arrows_any(known))
        forces->pixels = tinker_force_arrows_scale(known, view, 0);
    if (tinker_force_arrows_outgrow(forces->acting, view, forces->pixels))
        forces->pixels = tinker_force_arrows_scale(forces->acting, view, 0);
    if (forces->vectors != NULL && forces->greatest == NULL) tinker_motion_vectors_measure(forces->vectors, greatest);
    for (int k = 0; k < TINKER_VECTOR_KINDS && forces->vectors != NULL; k++)
        if (!(forces->vector_pixels[k] > 0))
            forces->vector_pixels[k] =
                tinker_motion_vectors_scale(forces->greatest != NULL ? forces->greatest[k] : greatest[k], view, 0);
    tinker_force_arrows_draw(forces, cairo, view, theme);
}
