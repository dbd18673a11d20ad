/* One block in the picture: what it is, the box it takes, and its drawing; for blocks without a render interface the
 * host's own drawing: a connector is a line, anything else a box. */
#include "render/picture/painter-private.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include "render/draw/draw-watch.h"

#define SIZE_SAMPLES 64

static double column_of(const TinkerPiece *piece, int32_t meaning)
{
    int32_t column = tinker_block_class_meaning_column(piece->block_class, meaning);
    if (column < 0 || !piece->instance.columns) return 0;
    double value = piece->instance.columns[column];
    return isfinite(value) ? fabs(value) : 0;
}

void tinker_piece_classify(TinkerPiece *piece)
{
    gboolean placed = isfinite(piece->instance.x) && isfinite(piece->instance.y);
    if (piece->instance.ends > 0) {
        piece->kind = TINKER_PIECE_CONNECTOR;
        return;
    }
    gboolean has_place = piece->block_class->meanings[TINKER_MEANING_POSITION] >= 0;
    piece->kind = has_place || placed ? TINKER_PIECE_BODY : TINKER_PIECE_FIELD;
    piece->width = column_of(piece, TINKER_MEANING_WIDTH);
    piece->height = column_of(piece, TINKER_MEANING_HEIGHT);
}

void tinker_piece_init(TinkerPiece *piece, TinkerFrame *frame, TinkerBlockId block)
{
    *piece = (TinkerPiece){.block = block};
    piece->block_class = tinker_scene_block_class(tinker_frame_scene(frame), block);
    gboolean known = tinker_frame_instance(frame, block, &piece->instance) && piece->block_class;
    gboolean placed = isfinite(piece->instance.x) && isfinite(piece->instance.y);
    if (!known) {
        piece->block_class = NULL;
        piece->instance.ends = 0;
        piece->kind = placed ? TINKER_PIECE_UNKNOWN : TINKER_PIECE_FIELD;
        return;
    }
    tinker_piece_classify(piece);
}

static void extend(double box[4], double x, double y, double room_x, double room_y)
{
    box[0] = fmin(box[0], x - room_x);
    box[1] = fmin(box[1], y - room_y);
    box[2] = fmax(box[2], x + room_x);
    box[3] = fmax(box[3], y + room_y);
}

/* The box about the ends, or about the size of a body, with room for marks. */
static void default_box(const TinkerPiece *piece, const TinkerStyle *style, double box[4])
{
    const TinkerInstance *instance = &piece->instance;
    double room = style->symbol_size / 2 + 2 * tinker_style_line_width(style);
    for (int32_t end = 0; end < instance->ends; end++)
        extend(box, instance->end[end].x, instance->end[end].y, room, room);
    if (instance->ends > 0) return;
    double c = fabs(cos(instance->orientation)), s = fabs(sin(instance->orientation));
    double half_x = (piece->width * c + piece->height * s) / 2, half_y = (piece->width * s + piece->height * c) / 2;
    gboolean plain = !piece->block_class || !piece->block_class->render;
    double least = plain ? style->symbol_size : room;
    extend(box, instance->x, instance->y, fmax(half_x + room / 2, least), fmax(half_y + room / 2, least));
}

gboolean tinker_piece_box(const TinkerPiece *piece, const TinkerStyle *style, double box[4])
{
    const TinkerRender *render = piece->block_class ? piece->block_class->render : NULL;
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    if (render && render->bounds)
        TINKER_CALL_VOID(render->bounds(&piece->instance, style, box), .phase = "bounds",
                         .block_class = piece->block_class, .instance = &piece->instance);
    else
        default_box(piece, style, box);
    return tinker_style_finite(box, 4) && box[0] <= box[2] && box[1] <= box[3];
}

/* A body's size, or the length that a connector keeps or tends to; what is longer than the scene says to be wide counts
 * as so long. */
static double size_of(const TinkerPiece *piece, double canvas_width)
{
    if (piece->kind == TINKER_PIECE_BODY) {
        double size = fmax(piece->width, piece->height);
        if (canvas_width > 0) size = fmin(size, canvas_width);
        return piece->width > 0 && piece->height > 0 ? fmax(fmin(piece->width, piece->height), size / 4) : size;
    }
    return piece->kind == TINKER_PIECE_CONNECTOR ? column_of(piece, TINKER_MEANING_LENGTH) / 2 : 0;
}

static int compare_doubles(gconstpointer a, gconstpointer b)
{
    double difference = *(const double *)a - *(const double *)b;
    return (difference > 0) - (difference < 0);
}

double tinker_frame_typical_size(TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const double canvas_width = tinker_scene_head(scene)->canvas_width;
    int32_t count = tinker_scene_block_count(scene);
    int32_t stride = MAX(count / SIZE_SAMPLES, 1);
    double sizes[2 * SIZE_SAMPLES];
    int samples = 0;
    for (int32_t place = 0; place < count && samples < 2 * SIZE_SAMPLES; place += stride) {
        TinkerPiece piece;
        tinker_piece_init(&piece, frame, tinker_scene_block_at(scene, place));
        double size = size_of(&piece, canvas_width);
        if (size > 0) sizes[samples++] = size;
    }
    if (!samples) return 0;
    qsort(sizes, (size_t)samples, sizeof *sizes, compare_doubles);
    return sizes[samples / 2];
}

static void draw_plain(const TinkerPiece *piece, cairo_t *cairo, const TinkerStyle *style)
{
    const TinkerInstance *instance = &piece->instance;
    const TinkerEnd *end = instance->end;
    if (instance->ends > 0) {
        for (int32_t i = 1; i < instance->ends; i++)
            style->line(style, cairo, TINKER_COLOUR_CONNECTOR, end[i - 1].x, end[i - 1].y, end[i].x, end[i].y);
        for (int32_t i = 0; i < instance->ends; i++)
            style->end_mark(style, cairo, end[i].x, end[i].y, end[i].attached);
        return;
    }
    double least = 1.6 * style->symbol_size;
    double width = fmax(piece->width, least), height = fmax(piece->height, least);
    style->box(style, cairo, TINKER_COLOUR_BODY, piece->block_class ? TINKER_COLOUR_BODY_EDGE : TINKER_COLOUR_WARNING,
               instance->x, instance->y, width, height, instance->orientation);
    if (!piece->block_class) style->text(style, cairo, TINKER_COLOUR_WARNING, instance->x, instance->y, "?");
}

char *tinker_piece_draw(const TinkerPiece *piece, cairo_t *cairo, const TinkerStyle *style)
{
    const TinkerRender *render = piece->block_class ? piece->block_class->render : NULL;
    TinkerDrawWatch watch;
    tinker_draw_watch_begin(&watch, cairo);
    if (render && render->draw)
        TINKER_CALL_VOID(render->draw(&piece->instance, cairo, style), .phase = "draw",
                         .block_class = piece->block_class, .instance = &piece->instance);
    else
        draw_plain(piece, cairo, style);
    char *fault = tinker_draw_watch_end(&watch, cairo);
    if (fault == NULL) cairo_new_path(cairo);
    return fault;
}

/* Takes the text. */
static void tell_fault(const TinkerPicture *picture, const TinkerPiece *piece, char *fault)
{
    GHashTable *faults = picture->options->faults;
    if (faults != NULL && piece->block_class != NULL && !g_hash_table_contains(faults, piece->block_class)) {
        const char *name = tinker_scene_block_name(tinker_frame_scene(picture->frame), piece->block);
        char *text = g_strdup_printf(_("%s: its drawing (block type %s, plugin %s) %s"), name,
                                     piece->block_class->type->id, piece->block_class->path, fault);
        g_hash_table_insert(faults, (gpointer)piece->block_class, text);
    }
    g_free(fault);
}

void tinker_picture_draw_piece(TinkerPicture *picture, const TinkerPiece *piece)
{
    char *fault = tinker_piece_draw(piece, picture->cairo, &picture->brush.style);
    if (fault == NULL) return;
    tell_fault(picture, piece, fault);
    cairo_destroy(picture->cairo);
    picture->cairo = tinker_context_new(picture->caller);
    tinker_style_enter_world(&picture->brush.style, picture->cairo);
}
