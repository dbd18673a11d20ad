/* An icon is the drawing of a mock instance that is in no scene. What a default leaves open is chosen so that there is
 * something to be seen: connectors lie between a left and a right end at their rest length, waveforms are at their
 * amplitude, a field that would be still acts along x. The drawing is measured, and made anew with symbols and a scale
 * that fit. */
#include "render/picture/icon.h"

#include <math.h>
#include <string.h>

#include "render/draw/draw-watch.h"
#include "render/picture/painter-private.h"
#include "units/quantity/point-text.h"

#define MARGIN          0.06 /* of the lesser side */
#define SYMBOL_SHARE    0.42 /* of the lesser side: symbols, unless they do not fit */
#define BODY_SHARE      0.8  /* of a side: the body, at first */
#define LINE_SHARE      0.88 /* of the width: from end to end of a connector */
#define DOT_SHARE       0.13 /* of the symbol: radius of the dots at ends */
#define ROUNDS          3    /* of measuring: drawings do not grow quite as symbols do */
#define GREATEST_EXTENT 1e4  /* times the icon: a larger drawing is left out */

/* The mock. */
typedef struct {
    TinkerPiece piece;
    double *columns;
    TinkerEnd *ends;
    GArray *points; /* of `list`; NULL: there are none */
    TinkerPointList list;
} Mock;

/* How it is drawn: canvas units per m, the size of symbols in canvas units, and the point of the canvas where it
 * stands. */
typedef struct {
    double width, height;
    double scale, symbol;
    double x, y;
} Fit;

static double *column_of(Mock *mock, const char *id)
{
    const TinkerBlockClass *block_class = mock->piece.block_class;
    int32_t property = id ? tinker_block_class_property(block_class, id) : -1;
    return property < 0 ? NULL : &mock->columns[block_class->first_columns[property]];
}

static void set_plain_defaults(Mock *mock, gboolean is_field)
{
    const TinkerBlockClass *block_class = mock->piece.block_class;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        double *column = &mock->columns[block_class->first_columns[i]];
        int32_t count = MIN(tinker_kind_columns(property->kind), 2);
        if (property->kind == TINKER_KIND_WAVEFORM) continue;
        for (int32_t k = 0; k < count; k++)
            column[k] = isfinite(property->default_value[k]) ? property->default_value[k] : 0;
        if (property->meaning == TINKER_MEANING_POSITION || property->meaning == TINKER_MEANING_LOCAL_ORIGIN)
            column[0] = column[1] = 0;
        else if (is_field && property->kind == TINKER_KIND_VECTOR && column[0] == 0 && column[1] == 0)
            column[0] = 1;
    }
}

/* Those that follow from other properties, or from where the ends are. */
static void set_other_defaults(Mock *mock, double length)
{
    const TinkerBlockClass *block_class = mock->piece.block_class;
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        double *column = &mock->columns[block_class->first_columns[i]];
        const double *from = column_of(mock, property->default_from), *amplitude = column_of(mock, property->amplitude);
        if (property->flags & TINKER_DEFAULT_AS_PLACED)
            column[0] = property->meaning == TINKER_MEANING_RADIUS ? 0.25 * length : length;
        else if ((property->flags & TINKER_DEFAULT_SAME_AS) && from)
            memcpy(column, from, sizeof *column * (gsize)MIN(tinker_kind_columns(property->kind), 2));
        else if (property->kind == TINKER_KIND_WAVEFORM)
            column[0] = amplitude && *amplitude != 0 ? *amplitude : 1;
        if (property->meaning == TINKER_MEANING_LENGTH && length > 0) column[0] = length;
    }
}

/* Of its first list of points: no block has more yet. */
static void take_default_points(Mock *mock)
{
    const TinkerBlockClass *block_class = mock->piece.block_class;
    for (int32_t i = 0; i < block_class->property_count && mock->points == NULL; i++) {
        const TinkerPropertyType *property = &block_class->properties[i];
        if ((property->flags & TINKER_TEXT_POINTS) == 0 || property->default_text == NULL) continue;
        mock->points = tinker_point_text_parse(property->default_text, property->dimension, NULL);
        if (mock->points == NULL) continue;
        mock->list.points = (const double *)(void *)mock->points->data;
        mock->list.count = (int32_t)mock->points->len / 2;
        mock->piece.instance.point_lists = &mock->list;
        mock->piece.instance.point_list_count = 1;
    }
}

static void mock_init(Mock *mock, const TinkerBlockClass *block_class, double length)
{
    int32_t ends = MAX(block_class->type->least_ends, 0);
    double span = ends > 1 ? length : 0;
    *mock = (Mock){.piece = {.block = TINKER_NO_BLOCK, .block_class = block_class}};
    mock->columns = g_new0(double, MAX(block_class->column_count, 1) + 2);
    mock->ends = g_new0(TinkerEnd, MAX(ends, 1));
    for (int32_t k = 0; k < ends; k++)
        mock->ends[k] = (TinkerEnd){ends > 1 ? span * (k / (ends - 1.0) - 0.5) : 0, 0, 1, 0, 0};
    gboolean is_field = ends == 0 && block_class->meanings[TINKER_MEANING_POSITION] < 0;
    set_plain_defaults(mock, is_field);
    set_other_defaults(mock, span);
    int32_t orientation = tinker_block_class_meaning_column(block_class, TINKER_MEANING_ORIENTATION);
    mock->piece.instance = (TinkerInstance){
        .struct_size = sizeof(TinkerInstance),
        .name = block_class->type->title,
        .orientation = orientation >= 0 ? mock->columns[orientation] : 0,
        .columns = mock->columns,
        .ends = ends,
        .end = mock->ends,
    };
    take_default_points(mock);
    tinker_piece_classify(&mock->piece);
    /* In a scene it would stand nowhere. */
    if (is_field) mock->piece.kind = TINKER_PIECE_FIELD;
}

static void mock_clear(Mock *mock)
{
    g_free(mock->columns);
    g_free(mock->ends);
    g_clear_pointer(&mock->points, g_array_unref);
}

/* Ends are dots here: nothing is there that they could be attached to. */
static void draw_end(const TinkerStyle *style, cairo_t *cairo, double x, double y, int32_t attached)
{
    (void)attached;
    style->circle(style, cairo, TINKER_COLOUR_CONNECTOR, -1, x, y, DOT_SHARE * style->symbol_size);
}

/* Values are of no use here, and too small to be read. */
static void draw_no_text(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x, double y, const char *text)
{
}

/* Draws the mock about the fit's point. */
static void draw(cairo_t *cairo, Mock *mock, const TinkerTheme *theme, const Fit *fit)
{
    TinkerView view = {fit->scale, fit->x, fit->y, fit->width, fit->height};
    TinkerStyleBrush brush;
    tinker_style_begin(&brush, cairo, theme, &view, fit->symbol / fit->scale);
    brush.style.end_mark = draw_end;
    if (mock->piece.instance.ends > 1) brush.style.text = draw_no_text;
    /* Helpers draw what is visible: all of it is. */
    double far = GREATEST_EXTENT * fmax(fit->width, fit->height) / fit->scale;
    brush.style.view[0] = brush.style.view[1] = -far;
    brush.style.view[2] = brush.style.view[3] = far;
    mock->piece.instance.symbol_size = brush.style.symbol_size;
    cairo_t *own = tinker_context_new(cairo);
    tinker_style_enter_world(&brush.style, own);
    g_free(tinker_piece_draw(&mock->piece, own, &brush.style)); /* a picture of the scene tells of it */
    cairo_destroy(own);
    tinker_style_end(&brush);
}

/* The box of the ink. FALSE where there is none, or far too much. */
static gboolean measure(Mock *mock, const TinkerTheme *theme, const Fit *fit, double box[4])
{
    cairo_surface_t *ink = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(ink);
    draw(cairo, mock, theme, fit);
    cairo_recording_surface_ink_extents(ink, &box[0], &box[1], &box[2], &box[3]);
    cairo_destroy(cairo);
    cairo_surface_destroy(ink);
    double extent = fmax(fabs(box[0]), fabs(box[1])) + fmax(box[2], box[3]);
    return box[2] > 0 && box[3] > 0 && extent < GREATEST_EXTENT * fmax(fit->width, fit->height);
}

/* The first guess; a body by its size, or as if that were 1 m; anything else by its symbols. */
static Fit first_fit(const Mock *mock, double width, double height)
{
    Fit fit = {.width = width, .height = height, .scale = 1, .symbol = SYMBOL_SHARE * fmin(width, height)};
    const TinkerPiece *piece = &mock->piece;
    if (piece->kind != TINKER_PIECE_BODY) return fit;
    double across = piece->width > 0 ? BODY_SHARE * width / piece->width : INFINITY;
    double up = piece->height > 0 ? BODY_SHARE * height / piece->height : INFINITY;
    fit.scale = isfinite(fmin(across, up)) ? fmin(across, up) : BODY_SHARE * fmin(width, height);
    return fit;
}

/* The picture that the block brings along, as large as fits. FALSE where it brings none, or none that can be read. */
static gboolean paint_own_picture(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height)
{
    if (block_class->type->icon_path == NULL) return FALSE;
    g_autofree char *folder = g_path_get_dirname(block_class->path);
    g_autofree char *path = g_build_filename(folder, block_class->type->icon_path, NULL);
    cairo_surface_t *picture = cairo_image_surface_create_from_png(path);
    const double across = cairo_image_surface_get_width(picture), up = cairo_image_surface_get_height(picture);
    const gboolean fine = cairo_surface_status(picture) == CAIRO_STATUS_SUCCESS && across > 0 && up > 0;
    if (fine) {
        const double scale = fmin(width / across, height / up);
        cairo_save(cairo);
        cairo_translate(cairo, (width - scale * across) / 2, (height - scale * up) / 2);
        cairo_scale(cairo, scale, scale);
        cairo_set_source_surface(cairo, picture, 0, 0);
        cairo_paint(cairo);
        cairo_restore(cairo);
    }
    cairo_surface_destroy(picture);
    return fine;
}

static void paint_drawing(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                          const TinkerTheme *theme)
{
    Mock mock;
    double box[4], margin = MARGIN * fmin(width, height), room_x = width - 2 * margin, room_y = height - 2 * margin;
    mock_init(&mock, block_class, LINE_SHARE * width);
    Fit fit = first_fit(&mock, width, height);
    gboolean fine = measure(&mock, theme, &fit, box);
    for (int round = 0; fine && round < ROUNDS && (box[2] > room_x || box[3] > room_y); round++) {
        double share = fmin(room_x / box[2], room_y / box[3]);
        fit.symbol *= share;
        /* The ends of a connector stay where they are: only its symbol is too high. */
        if (mock.piece.kind == TINKER_PIECE_BODY || box[2] > room_x) fit.scale *= share;
        fine = measure(&mock, theme, &fit, box);
    }
    fit.x = width / 2 - (box[0] + box[2] / 2);
    fit.y = height / 2 - (box[1] + box[3] / 2);
    cairo_save(cairo);
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_clip(cairo);
    if (fine) draw(cairo, &mock, theme, &fit);
    cairo_restore(cairo);
    mock_clear(&mock);
}

void tinker_paint_block_icon(cairo_t *cairo, const TinkerBlockClass *block_class, double width, double height,
                             const TinkerTheme *theme)
{
    if (!(width >= 4) || !(height >= 4) || !isfinite(width) || !isfinite(height)) return;
    if (!paint_own_picture(cairo, block_class, width, height)) paint_drawing(cairo, block_class, width, height, theme);
}
