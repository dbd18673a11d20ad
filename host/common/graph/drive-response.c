/* A resonance is a peak of the response and not just a natural frequency: what drives a scene up and down is near none
 * of those at which it swings sideways. */
#include "common/graph/drive-response.h"

#include <glib/gi18n.h>
#include <math.h>

#include "common/overlay/motion-vectors.h"

#define NEAR        0.15 /* of the peak's frequency */
#define MOST_DRIVES 8
#define MOST_BODIES 20 /* that are asked for their answer */
#define POINTS      200
#define BESIDE      1.03 /* of a natural frequency: where answers are compared, off the peak itself */

static void free_response(gpointer data)
{
    TinkerDriveResponse *response = data;
    g_free(response->drive);
    g_free(response->quantity);
    g_free(response->unit);
    g_array_unref(response->hertz);
    g_array_unref(response->amplitude);
    g_free(response);
}

/* The angular frequency of a block's sine, NAN where it has none. */
static double driven_at(const TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    for (int32_t i = 0; i < block_class->property_count; i++) {
        const TinkerPropertyType *type = &block_class->properties[i];
        TinkerNumber number;
        if (type->kind != TINKER_KIND_WAVEFORM || type->frequency == NULL) continue;
        const TinkerWaveformKind kind = tinker_waveform_kind(tinker_scene_get_waveform(scene, block, i));
        if (kind != TINKER_WAVEFORM_SINE && kind != TINKER_WAVEFORM_COSINE) continue;
        if (tinker_scene_find_number(scene, block, type->frequency, &number))
            return tinker_scene_get(scene, block, number.column);
    }
    return NAN;
}

/* What is asked: how a body answers along x or y. */
typedef struct {
    const TinkerModeAnalysis *analysis;
    TinkerScene *scene;
    const TinkerLinearInput *input;
} Question;

/* The response of a quantity, with the column that it is of. NULL where it cannot be worked out. */
static TinkerFrequencyResponse *response_of(const Question *question, GArray *columns, TinkerLinearOutput *output)
{
    const TinkerModeAnalysis *analysis = question->analysis;
    const TinkerColumn *column = &g_array_index(columns, TinkerColumn, 0);
    if (!tinker_linear_output_find(analysis->model, analysis->q, column, question->input, output, NULL)) return NULL;
    return tinker_frequency_response_new(analysis->linear, analysis->basis, question->input, output, NULL);
}

/* How much a response rises beside the natural frequencies. */
static double rise_of(TinkerFrequencyResponse *response, const GPtrArray *modes)
{
    double rise = 0;
    for (guint i = 0; i < modes->len; i++) {
        const TinkerMode *mode = g_ptr_array_index(modes, i);
        const double size = mode->kind == TINKER_MODE_OSCILLATION
                                ? cabs(tinker_frequency_response_at(response, BESIDE * mode->natural))
                                : 0;
        if (isfinite(size)) rise = fmax(rise, size);
    }
    return rise;
}

static void fill(TinkerDriveResponse *filled, TinkerFrequencyResponse *response, const GPtrArray *modes)
{
    double from, to, nearest = NEAR;
    tinker_frequency_response_range(modes, &from, &to);
    g_autoptr(GArray) grid = tinker_frequency_response_grid(modes, from, to, POINTS, TRUE);
    g_autoptr(GArray) peaks = tinker_frequency_response_peaks(response, grid);
    g_array_set_size(filled->hertz, 0);
    g_array_set_size(filled->amplitude, 0);
    filled->resonance = NAN;
    for (guint i = 0; i < grid->len; i++) {
        const double omega = g_array_index(grid, double, i), hertz = omega / (2 * G_PI);
        double size = cabs(tinker_frequency_response_at(response, omega));
        if (!isfinite(size)) size = NAN;
        g_array_append_val(filled->hertz, hertz);
        g_array_append_val(filled->amplitude, size);
    }
    for (guint i = 0; i < peaks->len; i++) {
        const double hertz = g_array_index(peaks, TinkerResponsePeak, i).omega / (2 * G_PI);
        const double off = fabs(filled->driven / hertz - 1);
        if (!(off <= nearest)) continue;
        nearest = off;
        filled->resonance = hertz;
    }
}

/* The answer that rises most is that of the drive. FALSE where nothing answers. */
static gboolean find_answer(const Question *question, TinkerDriveResponse *answer)
{
    double most = 0;
    int asked = 0;
    for (int32_t place = 0; place < tinker_scene_block_count(question->scene) && asked < MOST_BODIES; place++) {
        const TinkerBlockId block = tinker_scene_block_at(question->scene, place);
        if (!tinker_block_moves(question->scene, block)) continue;
        asked++;
        for (int axis = 0; axis < 2; axis++) {
            g_autoptr(GArray) columns = tinker_columns_new();
            g_autofree char *name =
                g_strconcat(tinker_scene_block_name(question->scene, block), axis == 0 ? ".x" : ".y", NULL);
            if (!tinker_columns_add(columns, question->scene, name, NULL)) continue;
            g_auto(TinkerLinearOutput) output = {0};
            g_autoptr(TinkerFrequencyResponse) response = response_of(question, columns, &output);
            const double rise = response != NULL ? rise_of(response, question->analysis->modes) : 0;
            if (!(rise > most)) continue;
            most = rise;
            g_free(answer->quantity);
            answer->quantity = g_steal_pointer(&name);
            fill(answer, response, question->analysis->modes);
        }
    }
    return most > 0;
}

static gboolean drives(const TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    gboolean has_waveform = FALSE;
    for (int32_t i = 0; block_class != NULL && i < block_class->property_count; i++)
        has_waveform = has_waveform || block_class->properties[i].kind == TINKER_KIND_WAVEFORM;
    return has_waveform;
}

GPtrArray *tinker_drive_responses_new(const TinkerModeAnalysis *analysis, TinkerScene *scene)
{
    GPtrArray *responses = g_ptr_array_new_with_free_func(free_response);
    for (int32_t place = 0; place < tinker_scene_block_count(scene) && responses->len < MOST_DRIVES; place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        g_auto(TinkerLinearInput) input = {0};
        if (!drives(scene, block)) continue;
        if (!tinker_linear_input_find(analysis->model, tinker_scene_block_name(scene, block), &input, NULL)) continue;
        const Question question = {analysis, scene, &input};
        TinkerDriveResponse *response = g_new0(TinkerDriveResponse, 1);
        response->drive = g_strdup(tinker_scene_block_name(scene, block));
        response->unit = tinker_frequency_response_unit("m", input.unit);
        response->driven = driven_at(scene, block) / (2 * G_PI);
        response->hertz = g_array_new(FALSE, FALSE, sizeof(double));
        response->amplitude = g_array_new(FALSE, FALSE, sizeof(double));
        if (find_answer(&question, response))
            g_ptr_array_add(responses, response);
        else
            free_response(response);
    }
    return responses;
}

char *tinker_drive_response_sentence(const TinkerDriveResponse *response)
{
    if (isnan(response->resonance)) return NULL;
    return g_strdup_printf(_("%s drives with %.4g rad/s (%.4g Hz), near resonance at %.4g rad/s (%.4g Hz)"),
                           response->drive, 2 * G_PI * response->driven, response->driven,
                           2 * G_PI * response->resonance, response->resonance);
}

char *tinker_drive_response_hint(const TinkerDriveResponse *response)
{
    if (isnan(response->resonance)) return NULL;
    return g_strdup_printf(_("Near resonance at %.4g rad/s (%.4g Hz)"), 2 * G_PI * response->resonance,
                           response->resonance);
}
