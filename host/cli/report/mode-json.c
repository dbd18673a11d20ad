/* Modes as JSON. */
#include <math.h>

#include <cjson/cJSON.h>

#include "cli/report/mode-report.h"
#include "common/program/print.h"

#define HERTZ(omega) ((omega) / (2 * G_PI))

static void add_number(cJSON *object, const char *key, double value)
{
    if (isfinite(value))
        cJSON_AddNumberToObject(object, key, value);
    else
        cJSON_AddNullToObject(object, key);
}

static const char *name_of_body(const TinkerModeReport *report, int32_t body)
{
    return tinker_scene_block_name(report->scene, tinker_model_body_block(report->analysis->model, body));
}

static void add_state(cJSON *root, const TinkerModeReport *report)
{
    const TinkerModeAnalysis *analysis = report->analysis;
    double growth = tinker_modes_growth(analysis->modes), most = 0, origin[2];
    for (int32_t i = 0; i < analysis->linear->size; i++)
        most = fmax(most, fabs(analysis->linear->force[i]));
    cJSON_AddStringToObject(root, "state", analysis->about_rest ? "rest" : "start");
    cJSON_AddBoolToObject(root, "stable", growth == 0);
    add_number(root, "growth_rate", growth);
    add_number(root, "unbalanced_force", most);
    add_number(root, "degrees_of_freedom", analysis->basis->count);
    cJSON *places = cJSON_AddArrayToObject(root, "places");
    tinker_model_origin(analysis->model, origin);
    for (int32_t body = 0; body < tinker_model_sizes(analysis->model).bodies; body++) {
        cJSON *place = cJSON_CreateObject();
        cJSON_AddStringToObject(place, "block", name_of_body(report, body));
        add_number(place, "x", origin[0] + analysis->q[2 * body]);
        add_number(place, "y", origin[1] + analysis->q[2 * body + 1]);
        double radius;
        const int32_t turn = tinker_model_body_turn(analysis->model, body, &radius);
        if (turn >= 0) add_number(place, "angle", analysis->q[turn] / radius);
        cJSON_AddItemToArray(places, place);
    }
}

static void add_contacts(cJSON *root, const TinkerModeReport *report)
{
    cJSON *array = cJSON_AddArrayToObject(root, "assumed");
    if (report->analysis->contacts == NULL) return;
    g_autoptr(GArray) contacts = tinker_still_contacts_list(report->analysis->contacts);
    for (guint i = 0; i < contacts->len; i++) {
        const TinkerStillContact *contact = &g_array_index(contacts, TinkerStillContact, i);
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(report->scene, contact->block));
        if (contact->plate != TINKER_NO_BLOCK)
            cJSON_AddStringToObject(object, "on", tinker_scene_block_name(report->scene, contact->plate));
        cJSON_AddStringToObject(object, "contact", tinker_still_contact_kind_name(contact->kind));
        add_number(object, "force", contact->force);
        cJSON_AddBoolToObject(object, "friction_left_out", contact->rough);
        cJSON_AddItemToArray(array, object);
    }
}

/* Supports that move, with what is left out of their motion at the start. */
static void add_held(cJSON *root, const TinkerModeReport *report)
{
    cJSON *array = cJSON_AddArrayToObject(root, "held");
    g_autoptr(TinkerFrame) start = tinker_frame_new(report->scene, NULL);
    for (int32_t i = 0; start != NULL && i < tinker_scene_block_count(report->scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(report->scene, i);
        const TinkerPlace *place = tinker_frame_motion(start, block);
        if (place == NULL) continue;
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(report->scene, block));
        cJSON_AddItemToObject(object, "velocity", cJSON_CreateDoubleArray((const double[]){place->vx, place->vy}, 2));
        cJSON_AddItemToObject(object, "acceleration",
                              cJSON_CreateDoubleArray((const double[]){place->ax, place->ay}, 2));
        add_number(object, "rate", place->rate);
        add_number(object, "angular_acceleration", place->angular_acceleration);
        cJSON_AddItemToArray(array, object);
    }
}

static const char *name_of_kind(TinkerLeftOutKind kind)
{
    return kind == TINKER_LEFT_OUT_CONTACT ? "contact" : kind == TINKER_LEFT_OUT_MOTION ? "motion" : "variation";
}

static void add_left_out(cJSON *root, const TinkerModeReport *report)
{
    const GArray *left_out = report->analysis->left_out;
    cJSON *array = cJSON_AddArrayToObject(root, "left_out");
    for (guint i = 0; i < left_out->len; i++) {
        const TinkerLeftOut *out = &g_array_index(left_out, TinkerLeftOut, i);
        cJSON *object = cJSON_CreateObject();
        cJSON_AddStringToObject(object, "block", tinker_scene_block_name(report->scene, out->block));
        if (out->kind == TINKER_LEFT_OUT_CONTACT)
            cJSON_AddStringToObject(object, "touches", tinker_scene_block_name(report->scene, out->other));
        cJSON_AddStringToObject(object, "what", name_of_kind(out->kind));
        cJSON_AddItemToArray(array, object);
    }
}

static void add_shape(cJSON *object, const TinkerModeReport *report, const TinkerMode *mode)
{
    cJSON *shape = cJSON_AddArrayToObject(object, "shape");
    for (int32_t body = 0; body < tinker_model_sizes(report->analysis->model).bodies; body++) {
        cJSON *component = cJSON_CreateObject();
        cJSON_AddStringToObject(component, "block", name_of_body(report, body));
        add_number(component, "x", mode->real[2 * body]);
        add_number(component, "y", mode->real[2 * body + 1]);
        add_number(component, "x_imaginary", mode->imaginary[2 * body]);
        add_number(component, "y_imaginary", mode->imaginary[2 * body + 1]);
        double radius;
        const int32_t turn = tinker_model_body_turn(report->analysis->model, body, &radius);
        if (turn >= 0) {
            add_number(component, "angle", mode->real[turn] / radius);
            add_number(component, "angle_imaginary", mode->imaginary[turn] / radius);
        }
        cJSON_AddItemToArray(shape, component);
    }
}

static void add_modes(cJSON *root, const TinkerModeReport *report)
{
    cJSON *modes = cJSON_AddArrayToObject(root, "modes");
    for (guint i = 0; i < report->count; i++) {
        const TinkerMode *mode = g_ptr_array_index(report->analysis->modes, i);
        cJSON *object = cJSON_CreateObject();
        add_number(object, "mode", i + 1);
        cJSON_AddStringToObject(object, "kind", tinker_mode_kind_name(mode->kind));
        add_number(object, "frequency_hz", HERTZ(mode->natural));
        add_number(object, "angular_frequency", mode->natural);
        add_number(object, "damped_frequency_hz", HERTZ(mode->frequency));
        add_number(object, "period", mode->frequency > 0 ? 1 / HERTZ(mode->frequency) : NAN);
        add_number(object, "damping_ratio", mode->damping_ratio);
        add_number(object, "decay_rate", mode->decay);
        add_shape(object, report, mode);
        cJSON_AddItemToArray(modes, object);
    }
    /* with every damper taken away */
    cJSON *undamped = cJSON_AddArrayToObject(root, "undamped_frequencies_hz");
    for (int32_t i = 0; i < report->analysis->basis->count; i++) {
        double square = report->analysis->basis->squares[i];
        cJSON_AddItemToArray(undamped, square >= 0 ? cJSON_CreateNumber(HERTZ(sqrt(square))) : cJSON_CreateNull());
    }
}

static void add_array(cJSON *object, const char *key, const GArray *values, double factor)
{
    cJSON *array = cJSON_AddArrayToObject(object, key);
    for (guint i = 0; i < values->len; i++) {
        double value = factor * g_array_index(values, double, i);
        cJSON_AddItemToArray(array, isfinite(value) ? cJSON_CreateNumber(value) : cJSON_CreateNull());
    }
}

static void add_response(cJSON *root, const TinkerModeReport *report)
{
    const TinkerModeResponse *response = report->response;
    if (response == NULL) return;
    cJSON *object = cJSON_AddObjectToObject(root, "response");
    cJSON_AddStringToObject(object, "input", tinker_scene_block_name(report->scene, response->input.block));
    cJSON_AddStringToObject(object, "output", g_array_index(response->columns, TinkerColumn, 0).name);
    cJSON_AddStringToObject(object, "unit", response->unit);
    cJSON *peaks = cJSON_AddArrayToObject(object, "peaks");
    for (guint i = 0; i < response->peaks->len; i++) {
        const TinkerResponsePeak *peak = &g_array_index(response->peaks, TinkerResponsePeak, i);
        cJSON *entry = cJSON_CreateObject();
        gboolean bounded = isfinite(cabs(peak->at));
        add_number(entry, "frequency_hz", HERTZ(peak->omega));
        add_number(entry, "amplitude", cabs(peak->at));
        add_number(entry, "phase_deg", bounded ? carg(peak->at) * 180 / G_PI : NAN);
        cJSON_AddItemToArray(peaks, entry);
    }
    add_array(object, "frequency_hz", response->grid, 1 / (2 * G_PI));
    add_array(object, "amplitude", response->amplitude, 1);
    add_array(object, "phase_deg", response->phase, 1);
}

void tinker_mode_report_write_json(const TinkerModeReport *report, FILE *file)
{
    cJSON *root = cJSON_CreateObject();
    add_state(root, report);
    add_contacts(root, report);
    add_held(root, report);
    add_left_out(root, report);
    add_modes(root, report);
    add_response(root, report);
    cJSON *warnings = cJSON_AddArrayToObject(root, "warnings");
    for (guint i = 0; i < report->warnings->len; i++)
        cJSON_AddItemToArray(warnings, cJSON_CreateString(g_ptr_array_index(report->warnings, i)));
    char *text = cJSON_Print(root);
    tinker_print_text(file, text);
    cJSON_free(text);
    cJSON_Delete(root);
}
