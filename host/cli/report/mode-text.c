/* The tables of modes. */
#include "cli/report/mode-report.h"

#include <math.h>

#include "cli/report/text-table.h"
#include "common/program/print.h"
#include "common/words/mode-words.h"

#define HERTZ(omega) ((omega) / (2 * G_PI))
/* Columns of shapes that stand beside one another. */
#define SHAPES_A_TABLE 5
/* Components smaller than this are rounding. */
#define NOTHING 5e-7

static void add_number(TinkerTextTable *table, double value)
{
    if (isfinite(value))
        tinker_text_table_add_format(table, "%.6g", value);
    else
        tinker_text_table_add(table, "");
}

static void write_state(const TinkerModeReport *report, FILE *file)
{
    const TinkerModeAnalysis *analysis = report->analysis;
    double growth = tinker_modes_growth(analysis->modes), most = 0;
    for (int32_t i = 0; i < analysis->linear->size; i++)
        most = fmax(most, fabs(analysis->linear->force[i]));
    tinker_print_line(file, "about:               %s", analysis->about_rest ? "rest" : "the start places, held still");
    tinker_print_line(file, "degrees of freedom:  %d", analysis->basis->count);
    if (!analysis->about_rest && most > analysis->linear->force_noise)
        tinker_print_line(file, "balanced:            no, forces of up to %.6g N are left", most);
    if (growth > 0)
        tinker_print_line(file, "stable:              no, a small push grows at %.6g 1/s", growth);
    else
        tinker_print_line(file, "stable:              yes");
}

static void write_contact(const TinkerModeReport *report, const TinkerStillContact *contact, FILE *file)
{
    const char *name = tinker_scene_block_name(report->scene, contact->block);
    const char *plate =
        contact->plate != TINKER_NO_BLOCK ? tinker_scene_block_name(report->scene, contact->plate) : NULL;
    switch (contact->kind) {
    case TINKER_STILL_SLIDES:
        tinker_print_line(file, "%s stays on %s and slides along it%s", name, plate,
                          contact->rough ? "; friction is left out" : "");
        return;
    case TINKER_STILL_STICKS:
        tinker_print_line(file, "%s stays where it is on %s, held by friction", name, plate);
        return;
    case TINKER_STILL_TOUCHES:
        tinker_print_line(file, "%s touches %s without pressing on it: it moves as if that were not there", name,
                          plate);
        return;
    case TINKER_STILL_TAUT:
        tinker_print_line(file, "%s stays taut", name);
        return;
    case TINKER_STILL_SLACK:
        tinker_print_line(file, "%s stays slack", name);
        return;
    }
}

/* A support that moves, and how it does at the start. */
static void write_held(const char *name, const TinkerPlace *place, FILE *file)
{
    g_autofree char *turning =
        place->turns ? g_strdup_printf("%.6g rad/s, %.6g rad/s^2", place->rate, place->angular_acceleration) : NULL;
    const gboolean moves = hypot(place->vx, place->vy) > 0 || hypot(place->ax, place->ay) > 0;
    g_autofree char *moving = moves || turning == NULL
                                  ? g_strdup_printf("%.6g m/s, %.6g m/s^2%s", hypot(place->vx, place->vy),
                                                    hypot(place->ax, place->ay), turning != NULL ? ", " : "")
                                  : g_strdup("");
    tinker_print_line(file, "%s is held still where it is at t = 0; its motion there, %s%s, is left out", name, moving,
                      turning != NULL ? turning : "");
}

/* What small motions are taken to leave as it is, and what is held still. */
static void write_assumed(const TinkerModeReport *report, FILE *file)
{
    const char *head = "assumed:";
    g_autoptr(GArray) contacts =
        report->analysis->contacts != NULL ? tinker_still_contacts_list(report->analysis->contacts) : NULL;
    for (guint i = 0; contacts != NULL && i < contacts->len; i++) {
        fprintf(file, "%-21s", head);
        write_contact(report, &g_array_index(contacts, TinkerStillContact, i), file);
        head = "";
    }
    g_autoptr(TinkerFrame) start = tinker_frame_new(report->scene, NULL);
    for (int32_t i = 0; start != NULL && i < tinker_scene_block_count(report->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(report->scene, i);
        const TinkerPlace *place = tinker_frame_motion(start, block);
        if (place == NULL) continue;
        fprintf(file, "%-21s", head);
        write_held(tinker_scene_block_name(report->scene, block), place, file);
        head = "";
    }
    g_autoptr(GPtrArray) left_out = tinker_modes_left_out(report->analysis, report->scene);
    for (guint i = 0; i < left_out->len; i++) {
        tinker_print_line(file, "%-21s%s", head, (const char *)g_ptr_array_index(left_out, i));
        head = "";
    }
}

static void write_modes(const TinkerModeReport *report, FILE *file)
{
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("rrrrrrl", 2);
    static const char *const heads[] = {"mode",          "frequency [Hz]", "[rad/s]", "period [s]",
                                        "damping ratio", "decay [1/s]",    "kind"};
    for (gsize i = 0; i < G_N_ELEMENTS(heads); i++)
        tinker_text_table_add(table, heads[i]);
    for (guint i = 0; i < report->count; i++) {
        const TinkerMode *mode = g_ptr_array_index(report->analysis->modes, i);
        tinker_text_table_add_format(table, "%u", i + 1);
        add_number(table, HERTZ(mode->natural));
        add_number(table, mode->natural);
        add_number(table, mode->frequency > 0 ? 1 / HERTZ(mode->frequency) : NAN);
        add_number(table, mode->damping_ratio);
        add_number(table, mode->kind == TINKER_MODE_RIGID ? NAN : mode->decay);
        tinker_text_table_add(table, tinker_mode_kind_name(mode->kind));
    }
    fputc('\n', file);
    tinker_text_table_write(table, file);
    guint rest = report->analysis->modes->len - report->count;
    if (rest > 0) tinker_print_line(file, "  and %u more (--count %u lists them)", rest, report->analysis->modes->len);
}

/* From -179 to 180. */
static int whole_degrees(double real, double imaginary)
{
    int degrees = (int)lround(atan2(imaginary, real) * 180 / G_PI);
    return degrees == -180 ? 180 : degrees;
}

static void add_component(TinkerTextTable *table, const TinkerMode *mode, int32_t coordinate, double radius,
                          gboolean standing)
{
    double real = mode->real[coordinate] / radius, imaginary = mode->imaginary[coordinate] / radius;
    if (hypot(real, imaginary) < NOTHING)
        tinker_text_table_add(table, "0");
    else if (standing)
        tinker_text_table_add_format(table, "%.4f", real);
    else
        tinker_text_table_add_format(table, "%.4f at %d deg", hypot(real, imaginary), whole_degrees(real, imaginary));
}

/* One coordinate of the modes from `first` to `end` - 1; of an angle `radius` is what it is multiplied by there. */
static void add_row(const TinkerModeReport *report, TinkerTextTable *table, const char *name, const char *component,
                    int32_t coordinate, double radius, guint first, guint end)
{
    const TinkerModeAnalysis *analysis = report->analysis;
    tinker_text_table_add(table, name);
    tinker_text_table_add(table, component);
    for (guint i = first; i < end; i++) {
        const TinkerMode *mode = g_ptr_array_index(analysis->modes, i);
        add_component(table, mode, coordinate, radius, tinker_mode_is_standing(mode, analysis->basis->size));
    }
}

static void write_shapes(const TinkerModeReport *report, guint first, guint end, FILE *file)
{
    const TinkerModeAnalysis *analysis = report->analysis;
    char alignments[SHAPES_A_TABLE + 3] = "ll";
    for (guint i = first; i < end; i++)
        g_strlcat(alignments, "r", sizeof alignments);
    g_autoptr(TinkerTextTable) table = tinker_text_table_new(alignments, 2);
    tinker_text_table_add(table, "shape");
    tinker_text_table_add(table, "");
    for (guint i = first; i < end; i++)
        tinker_text_table_add_format(table, "mode %u", i + 1);
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        double radius;
        const int32_t turn = tinker_model_body_turn(analysis->model, body, &radius);
        TinkerBlockId block = tinker_model_body_block(analysis->model, body);
        add_row(report, table, tinker_scene_block_name(report->scene, block), "x", 2 * body, 1, first, end);
        add_row(report, table, "", "y", 2 * body + 1, 1, first, end);
        if (turn >= 0) add_row(report, table, "", "angle [rad/m]", turn, radius, first, end);
    }
    fputc('\n', file);
    tinker_text_table_write(table, file);
}

static void write_response(const TinkerModeResponse *response, FILE *file)
{
    fputc('\n', file);
    tinker_print_line(file, "response of %s [%s]", response->name, response->unit);
    if (response->peaks->len == 0) {
        tinker_print_line(file, "  no peaks in this range");
        return;
    }
    g_autoptr(TinkerTextTable) table = tinker_text_table_new("rrr", 2);
    tinker_text_table_add(table, "peak [Hz]");
    tinker_text_table_add_format(table, "amplitude [%s]", response->unit);
    tinker_text_table_add(table, "phase [deg]");
    for (guint i = 0; i < response->peaks->len; i++) {
        const TinkerResponsePeak *peak = &g_array_index(response->peaks, TinkerResponsePeak, i);
        double height = cabs(peak->at);
        add_number(table, HERTZ(peak->omega));
        if (isfinite(height))
            add_number(table, height);
        else
            tinker_text_table_add(table, "no bound");
        add_number(table, isfinite(height) ? carg(peak->at) * 180 / G_PI : NAN);
    }
    tinker_text_table_write(table, file);
}

void tinker_mode_report_write_text(const TinkerModeReport *report, FILE *file)
{
    write_state(report, file);
    write_assumed(report, file);
    if (report->count > 0) write_modes(report, file);
    for (guint first = 0; first < report->count; first += SHAPES_A_TABLE)
        write_shapes(report, first, MIN(first + SHAPES_A_TABLE, report->count), file);
    if (report->response != NULL) write_response(report->response, file);
}
