/* tinker books: Newton's law, work and energy, impulse and momentum of bodies over an interval. */
#include <math.h>

#include "cli/command/open-scene.h"
#include "cli/command/options.h"
#include "cli/command/output.h"
#include "cli/command/picture.h"
#include "cli/command/run-arguments.h"
#include "cli/command/state-at.h"
#include "cli/report/books-json.h"
#include "cli/report/books-report.h"
#include "cli/verb/verbs.h"
#include "common/diagram/books-picture.h"
#include "common/program/exit-status.h"
#include "common/program/print.h"
#include "equations/balance/books.h"
#include "render/draw/surface.h"

static const TinkerVerbHelp help = {
    .verb = "books",
    .operands = "SCENE",
    .summary =
        "Keeps the books of bodies over an interval, three ways: Newton's law at its end, work and energy, impulse "
        "and\n"
        "momentum (linear, and angular about a point). Each lists what every force gave, and says what is left over.\n"
        "Of several bodies together, forces between them cancel, and only their work counts.\n"
        "With -o FILE.svg, .png or .pdf it draws them as bars.",
    .examples = "  tinker books pendulum.tinker.json\n"
                "  tinker books pendulum.tinker.json --block \"Mass 0\" --from 0.5 --to 2\n"
                "  tinker books bouncing-balls.tinker.json --to 1.5 --about 0,0.4\n"
                "  tinker books pendulum.tinker.json --as csv -o books.csv\n"
                "  tinker books pendulum.tinker.json -o books.svg --theme print",
    .least_operands = 1,
    .most_operands = 1,
};

typedef struct {
    TinkerRunArguments run;
    TinkerPictureArguments picture;
    char *from, *to, *about, *as, *output;
    char **blocks;
} BooksOptions;

static void books_options_clear(BooksOptions *options)
{
    tinker_run_arguments_clear(&options->run);
    tinker_picture_arguments_clear(&options->picture);
    g_free(options->from);
    g_free(options->to);
    g_free(options->about);
    g_free(options->as);
    g_free(options->output);
    g_strfreev(options->blocks);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(BooksOptions, books_options_clear)

enum { AS_TEXT, AS_JSON, AS_CSV };

/* What is asked for. */
typedef struct {
    double from, to, about[2];
    int as;
    gboolean is_picture;
    int width, height;
    const TinkerTheme *theme;
    TinkerBlockId *bodies; /* ended by -1; owned */
    TinkerRunOptions run;
} Wish;

static gboolean refuse(GError **error, const char *message)
{
    g_set_error_literal(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, message);
    return FALSE;
}

static gboolean read_about(const char *text, double about[2], GError **error)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    if (text == NULL) return TRUE;
    g_auto(GStrv) parts = g_strsplit(text, ",", -1);
    if (g_strv_length(parts) != 2) return refuse(error, "--about takes x and y of a point, as in --about 0,1.5");
    for (int axis = 0; axis < 2; axis++)
        if (!tinker_option_value("about", g_strstrip(parts[axis]), length, -INFINITY, FALSE, &about[axis], error))
            return FALSE;
    return TRUE;
}

static gboolean is_body(TinkerScene *scene, TinkerBlockId block)
{
    return tinker_block_class_moves(tinker_scene_block_class(scene, block));
}

/* The bodies that were named, or all. (transfer full) */
static TinkerBlockId *bodies_of(TinkerScene *scene, char *const *names, GError **error)
{
    g_autoptr(GArray) bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    if (names != NULL) {
        g_autofree TinkerBlockId *named = tinker_blocks_named(scene, names, error);
        for (const TinkerBlockId *each = named; each != NULL && *each >= 0; each++)
            if (!is_body(scene, *each)) {
                g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                            "--block \"%s\": it is no body that can move (books are kept of those)",
                            tinker_scene_block_name(scene, *each));
                return NULL;
            }
        return g_steal_pointer(&named);
    }
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (is_body(scene, block)) g_array_append_val(bodies, block);
    }
    const TinkerBlockId end = -1;
    g_array_append_val(bodies, end);
    return (TinkerBlockId *)(void *)g_array_free(g_steal_pointer(&bodies), FALSE);
}

static gboolean read_wish(const BooksOptions *options, const TinkerOpenScene *open, Wish *wish, GError **error)
{
    static const char *const formats[] = {"text", "json", "csv", NULL};
    static const TinkerDimension seconds = TINKER_DIMENSION_TIME;
    *wish = (Wish){.width = 900, .height = 720};
    if (!tinker_picture_or_text(&options->picture, options->output, options->as, &wish->is_picture, error) ||
        !tinker_picture_arguments_read(&options->picture, &wish->width, &wish->height, &wish->theme, error))
        return FALSE;
    if (options->as != NULL && !tinker_option_choice("as", options->as, formats, &wish->as, error)) return FALSE;
    if (options->from != NULL && !tinker_option_value("from", options->from, seconds, 0, FALSE, &wish->from, error))
        return FALSE;
    if (options->to != NULL && !tinker_option_value("to", options->to, seconds, 0, FALSE, &wish->to, error))
        return FALSE;
    if (!read_about(options->about, wish->about, error)) return FALSE;
    if (!tinker_run_options_to(open, &options->run, "to", wish->to, &wish->run, error)) return FALSE;
    if (options->to == NULL) wish->to = wish->run.duration;
    if (wish->to <= wish->from) return refuse(error, "--to must be later than --from");
    wish->bodies = bodies_of(open->scene, options->blocks, error);
    return wish->bodies != NULL;
}

static gboolean write_file(const BooksOptions *options, const TinkerOpenScene *open, const Wish *wish,
                           const TinkerBooks *books, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, options->output != NULL ? options->output : "-", error)) return FALSE;
    if (wish->as == AS_TEXT) {
        tinker_books_write_text(books, open->scene, wish->bodies, output.file);
    } else if (wish->as == AS_CSV) {
        tinker_books_write_csv(books, open->scene, output.file);
    } else {
        g_autofree char *text = tinker_books_json(books, open->scene, wish->bodies);
        tinker_print_text(output.file, text);
    }
    return tinker_output_close(&output, error);
}

static gboolean write_books(const BooksOptions *options, const TinkerOpenScene *open, Wish *wish, GError **error)
{
    const TinkerAskedOutput outputs[] = {{"--output", options->output}, {NULL, NULL}};
    g_autoptr(TinkerFileSet) files = tinker_open_scene_files(open);
    if (!tinker_outputs_add(files, outputs, error) || !read_wish(options, open, wish, error)) return FALSE;
    g_autoptr(TinkerBooks) books =
        tinker_books_new(open->scene, &wish->run, wish->bodies, wish->from, wish->to, wish->about, error);
    if (books == NULL) return FALSE;
    if (!wish->is_picture) return write_file(options, open, wish, books, error);
    TinkerBooksPicture picture = {open->scene, books, wish->bodies, wish->theme};
    return tinker_surface_to_file(tinker_books_draw, &picture, wish->width, wish->height, options->output, error);
}

int tinker_verb_books(int argc, char **argv)
{
    g_auto(BooksOptions) options = {0};
    const GOptionEntry entries[] = {
        {"block", 0, 0, G_OPTION_ARG_FILENAME_ARRAY, &options.blocks,
         "Of this body; given several times, of these together (all)", "NAME"},
        {"from", 0, 0, G_OPTION_ARG_FILENAME, &options.from, "Begin at this time (0)", "T"},
        {"to", 0, 0, G_OPTION_ARG_FILENAME, &options.to, "End at this time (the end of the run)", "T"},
        {"about", 0, 0, G_OPTION_ARG_FILENAME, &options.about, "Angular momentum about this point (0,0)", "X,Y"},
        {"as", 0, 0, G_OPTION_ARG_FILENAME, &options.as, "text, json or csv (text)", "FORMAT"},
        {"output", 'o', 0, G_OPTION_ARG_FILENAME, &options.output,
         "Write to FILE (standard output); .png, .svg or .pdf: draw", "FILE"},
        TINKER_PICTURE_LOOK_ENTRIES(options.picture, "900x720"),
        TINKER_RUN_METHOD_ENTRIES(options.run),
        TINKER_RUN_ACCURACY_ENTRY(options.run),
        G_OPTION_ENTRY_NULL,
    };
    g_auto(TinkerCommandLine) line = {0};
    g_auto(TinkerOpenScene) open = {0};
    int status = TINKER_EXIT_DONE;
    if (!tinker_open_scene_of_line(&open, &line, &help, entries, argc, argv, &status)) return status;
    g_autoptr(GError) error = NULL;
    Wish wish = {0};
    const gboolean done = write_books(&options, &open, &wish, &error);
    g_free(wish.bodies);
    return done ? TINKER_EXIT_DONE : tinker_open_scene_report_error(&open, error);
}
