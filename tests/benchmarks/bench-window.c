/* What the real window does: the time from its start to the first frame, frames a second while a scene plays, how long
 * a whole frame takes (from before-paint to after-paint), and how long the main loop lets an event wait. Needs a
 * display; with no graphics processor, GSK_RENDERER=cairo.
 *
 * bench-window runs itself once for each case, as `bench-window --case SCENE`, `--drag SCENE` or `--equations SCENE`,
 * so that every window is the first. */
#include <glib/gstdio.h>
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "folders.h"
#include "gui/app/application.h"
#include "gui/window/window-parts.h"
#include "report.h"
#include "scene-text.h"

#define WARM_UP  1.0 /* s of playing that do not count */
#define MEASURED 4.0 /* s that do */
#define TICK_MS  5   /* between events that ask whether the main loop answers */
#define DRAG_MS  15  /* between the edits of a property that is dragged */
#define PATIENCE 60  /* s: a window that has shown nothing by then never will */

typedef struct {
    GtkApplication *application;
    gboolean equations;  /* are shown while it plays */
    gint64 started;      /* us */
    double first_work;   /* ms of processor time until the first frame */
    gint64 first_frame;  /* us; 0: not yet */
    gint64 measure_from; /* us; 0: not yet */
    gint64 paint_began, last_event;
    GArray *frames; /* of double: ms each */
    GArray *work; /* of double: ms of processor time that the main thread had for each, the rest of its loop included */
    double work_until;   /* ms: of the thread, at the last frame's end */
    double longest_wait; /* ms */
    gint64 measured_until;
    double played_from; /* s of the scene's time, where measuring began */
} Measurement;

/* Processor time of this thread, ms: neighbours on the machine add nothing to it. */
static double thread_time(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * (double)time.tv_sec + 1e-6 * (double)time.tv_nsec;
}

static void on_before_paint(GdkFrameClock *clock, Measurement *measurement)
{
    measurement->paint_began = g_get_monotonic_time();
}

static double played(Measurement *measurement)
{
    GtkWindow *window = gtk_application_get_active_window(measurement->application);
    return tinker_player_time(TINKER_WINDOW(window)->player);
}

static void print_and_quit(Measurement *measurement)
{
    BenchmarkTiming frame =
        benchmark_summarize((double *)(gpointer)measurement->frames->data, measurement->frames->len);
    BenchmarkTiming work = benchmark_summarize((double *)(gpointer)measurement->work->data, measurement->work->len);
    double seconds = 1e-6 * (double)(measurement->measured_until - measurement->measure_from);
    g_print("%.17g %.17g %.17g %.17g %.17g %.17g %.17g\n",
            1e-3 * (double)(measurement->first_frame - measurement->started), measurement->frames->len / seconds,
            frame.median, measurement->longest_wait, work.median, measurement->first_work,
            (played(measurement) - measurement->played_from) / seconds);
    fflush(stdout);
    _Exit(0);
}

/* The page of equations, with the value of each term beneath it. */
static void show_equations(GtkWidget *widget)
{
    if (GTK_IS_CHECK_BUTTON(widget) && g_strcmp0(gtk_check_button_get_label(GTK_CHECK_BUTTON(widget)), "Values") == 0)
        gtk_check_button_set_active(GTK_CHECK_BUTTON(widget), TRUE);
    if (GTK_IS_STACK(widget) && gtk_stack_get_child_by_name(GTK_STACK(widget), "equations") != NULL)
        gtk_stack_set_visible_child_name(GTK_STACK(widget), "equations");
    for (GtkWidget *child = gtk_widget_get_first_child(widget); child != NULL;
         child = gtk_widget_get_next_sibling(child))
        show_equations(child);
}

static void on_after_paint(GdkFrameClock *clock, Measurement *measurement)
{
    gint64 now = g_get_monotonic_time();
    if (measurement->first_frame == 0) {
        measurement->first_frame = now;
        measurement->first_work = thread_time();
        measurement->last_event = now;
        GtkWindow *window = gtk_application_get_active_window(measurement->application);
        if (measurement->equations) show_equations(GTK_WIDGET(window));
        g_action_group_activate_action(G_ACTION_GROUP(window), "play", NULL);
        return;
    }
    gint64 playing = now - measurement->first_frame;
    if (playing < (gint64)(1e6 * WARM_UP)) return;
    if (measurement->measure_from == 0) {
        measurement->measure_from = now;
        measurement->work_until = thread_time();
        measurement->played_from = played(measurement);
        return;
    }
    double until = thread_time(), work = until - measurement->work_until;
    measurement->work_until = until;
    g_array_append_val(measurement->work, work);
    double ms = 1e-3 * (double)(now - measurement->paint_began);
    g_array_append_val(measurement->frames, ms);
    measurement->measured_until = now;
    if (now - measurement->measure_from > (gint64)(1e6 * MEASURED)) print_and_quit(measurement);
}

/* As long as this is late, the user's next key would have waited. */
static gboolean on_event(gpointer data)
{
    Measurement *measurement = data;
    gint64 now = g_get_monotonic_time();
    if (measurement->last_event > 0 && measurement->first_frame > 0)
        measurement->longest_wait =
            fmax(measurement->longest_wait, 1e-3 * (double)(now - measurement->last_event) - TICK_MS);
    measurement->last_event = now;
    return G_SOURCE_CONTINUE;
}

/* A hand on the slider of one stiffness, while the motion goes on. */
static gboolean on_drag(gpointer data)
{
    Measurement *measurement = data;
    GtkWindow *window = gtk_application_get_active_window(measurement->application);
    if (measurement->first_frame == 0 || window == NULL) return G_SOURCE_CONTINUE;
    TinkerDocument *document = TINKER_WINDOW(window)->document;
    TinkerScene *scene = tinker_document_scene(document);
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, place);
        const int32_t stiffness = tinker_block_class_property(tinker_scene_block_class(scene, block), "stiffness");
        if (stiffness < 0) continue;
        const double value = 20 + 5 * sin(1e-6 * (double)g_get_monotonic_time());
        tinker_document_begin(document, "Stiffness", NULL);
        tinker_history_set(tinker_document_history(document), block, stiffness, &value, NULL);
        tinker_document_end(document);
        break;
    }
    return G_SOURCE_CONTINUE;
}

static void on_window_added(GtkApplication *application, GtkWindow *window, Measurement *measurement)
{
    gtk_widget_realize(GTK_WIDGET(window));
    GdkFrameClock *clock = gtk_widget_get_frame_clock(GTK_WIDGET(window));
    g_signal_connect(clock, "before-paint", G_CALLBACK(on_before_paint), measurement);
    g_signal_connect_after(clock, "after-paint", G_CALLBACK(on_after_paint), measurement);
    g_timeout_add(TICK_MS, on_event, measurement);
}

static gboolean on_out_of_patience(gpointer data)
{
    g_error("the window does not play");
    return G_SOURCE_REMOVE;
}

/* One case, in a process of its own, with a home of its own. */
static int measure(char *program, char *scene, gboolean drags, gboolean equations)
{
    Measurement measurement = {.equations = equations,
                               .started = g_get_monotonic_time(),
                               .frames = g_array_new(FALSE, FALSE, sizeof(double)),
                               .work = g_array_new(FALSE, FALSE, sizeof(double))};
    gtk_disable_setlocale();
    g_timeout_add_seconds(PATIENCE, on_out_of_patience, NULL);
    g_autoptr(TinkerApplication) application = tinker_application_new();
    g_application_set_flags(G_APPLICATION(application), G_APPLICATION_HANDLES_OPEN | G_APPLICATION_NON_UNIQUE);
    measurement.application = GTK_APPLICATION(application);
    if (drags) g_timeout_add(DRAG_MS, on_drag, &measurement);
    g_signal_connect_after(application, "window-added", G_CALLBACK(on_window_added), &measurement);
    char *arguments[] = {program, scene, NULL};
    return g_application_run(G_APPLICATION(application), 2, arguments);
}

static void report_case(BenchmarkReport *report, char *program, const char *mode, const char *name, const char *path,
                        double frames_goal)
{
    const char *const arguments[] = {program, mode, path, NULL};
    g_autofree char *output = NULL;
    double values[7];
    if (!benchmark_report_wants(report, name)) return;
    g_autofree char *home = g_dir_make_tmp("bench-window-XXXXXX", NULL);
    g_auto(GStrv) environment = g_get_environ();
    static const char *const folders[] = {"XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"};
    for (gsize i = 0; i < G_N_ELEMENTS(folders); i++)
        environment = g_environ_setenv(environment, folders[i], home, TRUE);
    gboolean done =
        g_spawn_sync(NULL, (char **)arguments, environment, G_SPAWN_DEFAULT, NULL, NULL, &output, NULL, NULL, NULL);
    test_remove_all(home);
    if (!done || output[0] == '\0') return;
    char *next = output;
    for (int i = 0; i < 7; i++)
        values[i] = g_ascii_strtod(next, &next);
    benchmark_report_figure(report, name, "first frame after", values[0], "ms", 300);
    benchmark_report_figure(report, name, "frames a second", values[1], "1/s", NAN);
    benchmark_report_figure(report, name, "of its time, played a second", values[6], "s", NAN);
    benchmark_report_figure(report, name, "whole frame", values[2], "ms", 1e3 / frames_goal);
    benchmark_report_figure(report, name, "processor time a frame, everything", values[4], "ms", 1e3 / frames_goal);
    benchmark_report_figure(report, name, "processor time until the first frame", values[5], "ms", 300);
    benchmark_report_figure(report, name, "longest wait for an event", values[3], "ms", 50);
}

/* A generated scene with two graphs that are docked; "--case", "--drag" or "--equations". `interval` is how it records,
 * in s. */
static void report_text(BenchmarkReport *report, char *program, const char *mode, const char *name, char *text,
                        const char *interval, double frames_goal)
{
    g_autofree char *owned = text, *path = g_build_filename(g_get_tmp_dir(), "bench-window.tinker.json", NULL);
    char *end = g_strrstr(owned, "}");
    *end = '\0';
    g_auto(GStrv) parts = g_strsplit(owned, "\"step\": 0.001", 2);
    g_autofree char *whole =
        g_strconcat(parts[0], "\"step\": 0.001, \"duration\": 10, \"interval\": ", interval, parts[1],
                    ", \"graphs\": [{\"block\": \"M1\", \"quantity\": \"y\"}, "
                    "{\"block\": \"M2\", \"quantity\": \"y\"}]}",
                    NULL);
    if (!g_file_set_contents(path, whole, -1, NULL)) return;
    report_case(report, program, mode, name, path, frames_goal);
    g_unlink(path);
}

/* A wall of 2 000 boxes, ten rows high, that a heavy disc breaks: a pile of the impulse mode, 60 steps a second. */
static void report_wall(BenchmarkReport *report, char *program)
{
    g_autofree char *path = g_build_filename(g_get_tmp_dir(), "bench-window-wall.tinker.json", NULL);
    g_autofree char *text = benchmark_wall(2000);
    if (!g_file_set_contents(path, text, -1, NULL)) return;
    report_case(report, program, "--case", "a wall of 2000 boxes", path, 30);
    g_unlink(path);
}

int main(int argc, char **argv)
{
    if (argc == 3 && g_str_equal(argv[1], "--case")) return measure(argv[0], argv[2], FALSE, FALSE);
    if (argc == 3 && g_str_equal(argv[1], "--drag")) return measure(argv[0], argv[2], TRUE, FALSE);
    if (argc == 3 && g_str_equal(argv[1], "--equations")) return measure(argv[0], argv[2], FALSE, TRUE);
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    report_text(report, argv[0], "--case", "200 blocks, two graphs", benchmark_net(8), "0.01", 60);
    report_text(report, argv[0], "--equations", "25 bodies, equations and values", benchmark_net(5), "0.01", 60);
    report_text(report, argv[0], "--case", "5000 blocks", benchmark_net(41), "0.01", 20);
    /* About 1.3 GB of rows, of which 256 MB are kept in memory. */
    report_text(report, argv[0], "--case", "a record that outgrows its memory", benchmark_net(8), "2e-5", 60);
    report_text(report, argv[0], "--drag", "a property that is dragged", benchmark_net(8), "0.01", 60);
    report_text(report, argv[0], "--drag", "a property of 5000 blocks that is dragged", benchmark_net(41), "0.01", 20);
    report_wall(report, argv[0]);
    return benchmark_report_end(report);
}
