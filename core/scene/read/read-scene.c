/* Reading a scene: the scanner checks the text and finds its parts; then the head, each block on its own, what joins
 * them, and the graphs. A tree of the whole file would be many times its size. */
#include <errno.h>
#include <fcntl.h>
#include <glib/gi18n-lib.h>
#include <string.h>
#include <unistd.h>

#include "scene/json/text-hash.h"
#include "scene/read/scene-json.h"
#include "scene/value/reader.h"

/* How many names may be compared for suggestions; without a limit a large file with many wrong names takes minutes. */
#define MOST_COMPARED 2000000

#define MOST_STREAMED (1u << 30) /* bytes */

static void reader_init(SceneReader *reader, TinkerCatalogue *catalogue, const char *text, gsize length,
                        const char *path)
{
    gboolean is_file = path != NULL && !g_str_equal(path, "-");
    *reader = (SceneReader){
        .catalogue = catalogue,
        .scene = tinker_scene_new(catalogue),
        .text = text,
        .length = length,
        .path = is_file        ? path
                : path == NULL ? "scene"
                               : "standard input",
        .folder = is_file ? g_path_get_dirname(path) : g_strdup("."),
        .findings = g_array_new(FALSE, FALSE, sizeof(ReaderFinding)),
        .label_number = -1,
        .waveforms =
            g_hash_table_new_full(tinker_text_hash, g_str_equal, g_free, (GDestroyNotify)tinker_waveform_unref),
        .unnamed = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId)),
        .later_ends = g_array_new(FALSE, FALSE, sizeof(ReaderEnd)),
        .places_on = g_array_new(FALSE, FALSE, sizeof(ReaderPlaceOn)),
        .end_names = g_string_chunk_new(4096),
        .suggestions_left = MOST_COMPARED,
    };
}

static void reader_clear(SceneReader *reader)
{
    json_scan_clear(&reader->scan);
    g_array_unref(reader->findings);
    for (int i = 0; i < READER_MOST_STEPS; i++)
        g_clear_pointer(&reader->split[i].parts, g_array_unref);
    g_clear_pointer(&reader->types, g_hash_table_unref);
    g_hash_table_unref(reader->waveforms);
    g_array_unref(reader->unnamed);
    g_array_unref(reader->later_ends);
    g_array_unref(reader->places_on);
    g_string_chunk_free(reader->end_names);
    g_clear_pointer(&reader->block_names, g_ptr_array_unref);
    g_free(reader->folder);
}

/* The duplicates that no block has reported. */
static void report_other_duplicates(SceneReader *reader)
{
    const GArray *blocks = reader->scan.blocks;
    gsize from = 0;
    for (guint i = 0; i < blocks->len && reader->scan.duplicates->len > 0; i++) {
        const JsonPart *block = &g_array_index(blocks, JsonPart, i);
        reader_report_duplicates(reader, from, block->start);
        from = block->end;
    }
    reader_report_duplicates(reader, from, reader->length);
}

static void read_document(SceneReader *reader)
{
    if (!json_scan(&reader->scan, reader->text, reader->length)) {
        reader_error_at(reader, reader->scan.fault_at, TINKER_SCENE_ERROR_SYNTAX, "%s", reader->scan.fault);
        return;
    }
    gsize start = 0;
    while (g_ascii_isspace(reader->text[start]))
        start++;
    if (reader->text[start] != '{') {
        reader_error_at(reader, start, TINKER_SCENE_ERROR_SYNTAX,
                        _("not a scene: a scene is an object, {\"tinker\": 1, ...}"));
        return;
    }
    reader->document = start;
    reader_head(reader);
    for (guint i = 0; i < reader->scan.blocks->len; i++)
        reader_block(reader, (int)i);
    reader_count_missing(reader);
    reader_finish_blocks(reader);
    for (guint i = 0; i < reader->scan.members->len; i++) {
        const JsonPart *part = &g_array_index(reader->scan.members, JsonPart, i);
        if (json_key_is(reader->text, part, "graphs")) reader_graphs(reader, part);
        if (json_key_is(reader->text, part, "controls")) reader_instruments(reader, part, TRUE);
        if (json_key_is(reader->text, part, "meters")) reader_instruments(reader, part, FALSE);
    }
    report_other_duplicates(reader);
}

TinkerScene *reader_read_text(TinkerCatalogue *catalogue, const char *text, gsize length, const char *path,
                              GHashTable *waveforms, GPtrArray *findings, GError **error)
{
    SceneReader reader;
    reader_init(&reader, catalogue, text, length, path);
    reader.known_waveforms = waveforms;
    read_document(&reader);
    gboolean good = reader_conclude(&reader, findings, error);
    TinkerScene *scene = g_steal_pointer(&reader.scene);
    reader_clear(&reader);
    if (good) return scene;
    tinker_scene_free(scene);
    return NULL;
}

TinkerScene *tinker_scene_read_text(TinkerCatalogue *catalogue, const char *text, gsize length, const char *path,
                                    GPtrArray *findings, GError **error)
{
    return reader_read_text(catalogue, text, length, path, NULL, findings, error);
}

/* A file that could not be read is a finding without a place. */
static TinkerScene *unreadable(const char *path, const char *reason, GPtrArray *findings, GError **error)
{
    if (findings != NULL) {
        TinkerFinding *finding = g_new(TinkerFinding, 1);
        *finding = (TinkerFinding){TINKER_FINDING_ERROR, TINKER_SCENE_ERROR_FILE, 0, 0,
                                   g_strdup_printf(_("the file cannot be read: %s"), reason)};
        g_ptr_array_add(findings, finding);
    }
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, _("%s: the file cannot be read: %s"), path, reason);
    return NULL;
}

/* Twice the room for the text of a stream. FALSE, with why not. */
static gboolean enlarge(char **text, gsize *room, const char **why)
{
    const gsize more = MAX(2 * *room, 65536);
    char *larger = more <= MOST_STREAMED ? g_try_realloc(*text, more) : NULL;
    *why = more <= MOST_STREAMED ? _("there is no memory for a text of its length")
                                 : _("it has 1 GiB or more (such a scene must be a file)");
    if (larger == NULL) return FALSE;
    *text = larger;
    *room = more;
    return TRUE;
}

/* All that comes out of a stream. NULL, with why not. (transfer full) */
static char *read_all(int stream, gsize *length, const char **why)
{
    g_autofree char *text = NULL;
    gsize room = 0;
    *length = 0;
    while (*length < room || enlarge(&text, &room, why)) {
        const gssize count = read(stream, text + *length, room - *length);
        if (count == 0) return g_steal_pointer(&text);
        if (count > 0) *length += (gsize)count;
        if (count < 0 && errno != EINTR) {
            *why = g_strerror(errno);
            break;
        }
    }
    return NULL;
}

/* What cannot be mapped into memory: standard input, a pipe, a device; one without an end is given up. */
static TinkerScene *read_stream(TinkerCatalogue *catalogue, int stream, const char *path, GPtrArray *findings,
                                GError **error)
{
    gsize length = 0;
    const char *why = NULL;
    g_autofree char *text = read_all(stream, &length, &why);
    if (text == NULL) return unreadable(g_str_equal(path, "-") ? "standard input" : path, why, findings, error);
    return tinker_scene_read_text(catalogue, text, length, path, findings, error);
}

TinkerScene *tinker_scene_read_file(TinkerCatalogue *catalogue, const char *path, GPtrArray *findings, GError **error)
{
    if (g_str_equal(path, "-")) return read_stream(catalogue, STDIN_FILENO, path, findings, error);
    if (g_file_test(path, G_FILE_TEST_IS_DIR)) return unreadable(path, _("it is a folder"), findings, error);
    // Opened once: who writes into a pipe would find it closed between two times.
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return unreadable(path, g_strerror(errno), findings, error);
    GMappedFile *file = g_mapped_file_new_from_fd(descriptor, FALSE, NULL);
    TinkerScene *scene = NULL;
    if (file != NULL) {
        scene = tinker_scene_read_text(catalogue, g_mapped_file_get_contents(file), g_mapped_file_get_length(file),
                                       path, findings, error);
        g_mapped_file_unref(file);
    } else {
        scene = read_stream(catalogue, descriptor, path, findings, error);
    }
    close(descriptor);
    return scene;
}
