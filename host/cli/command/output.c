/* Outputs: opening early, closing with all errors told. */
#include "cli/command/output.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <unistd.h>

#include "common/program/exit-status.h"
#include "files/unfinished.h"
#include "files/write-lines.h"

gboolean tinker_is_standard_stream(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
}

gboolean tinker_outputs_add(TinkerFileSet *files, const TinkerAskedOutput *outputs, GError **error)
{
    gboolean has_stream = FALSE;
    for (const TinkerAskedOutput *output = outputs; output->option != NULL; output++) {
        if (output->path == NULL) continue;
        if (!tinker_file_set_add_output(files, output->option, output->path, error)) return FALSE;
        has_stream |= tinker_is_standard_stream(output->path);
    }
    // Where no output goes there, what is told does.
    return has_stream || tinker_file_set_add_output(files, NULL, "-", error);
}

static gboolean fail(const char *name, int reason, GError **error)
{
    g_autofree char *folder = g_path_get_dirname(name);
    if (reason == ENOENT && access(folder, F_OK) != 0)
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE,
                    "%s: cannot be written: the folder %s does not exist", name, folder);
    else
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: cannot be written: %s", name,
                    g_strerror(reason));
    return FALSE;
}

gboolean tinker_output_open(TinkerOutput *output, const char *path, GError **error)
{
    if (tinker_is_standard_stream(path)) {
        output->file = stdout;
        output->descriptor = STDOUT_FILENO;
        output->name = g_strdup("standard output");
        return TRUE;
    }
    g_autofree char *folder = g_path_get_dirname(path);
    tinker_unfinished_clean(folder);
    output->descriptor = g_open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (output->descriptor < 0) return fail(path, errno, error);
    output->file = fdopen(output->descriptor, "w");
    if (output->file == NULL) {
        const int reason = errno;
        close(output->descriptor);
        return fail(path, reason, error);
    }
    output->name = g_strdup(path);
    return TRUE;
}

static int reason_of(const TinkerOutput *output)
{
    if (output->reason != 0) return output->reason;
    return errno != 0 ? errno : EIO;
}

void tinker_output_lines(TinkerOutput *output, const char *text, gsize size)
{
    if (output->reason == 0 && !tinker_write_lines(output->descriptor, text, size)) output->reason = errno;
}

static gboolean has_failed(const TinkerOutput *output)
{
    return output->reason != 0 || ferror(output->file);
}

gboolean tinker_output_check(const TinkerOutput *output, GError **error)
{
    return has_failed(output) ? fail(output->name, reason_of(output), error) : TRUE;
}

gboolean tinker_output_close(TinkerOutput *output, GError **error)
{
    if (output->file == NULL) return TRUE;
    gboolean failed = has_failed(output);
    FILE *file = output->file;
    output->file = NULL;
    errno = 0;
    if ((file == stdout ? fflush(file) : fclose(file)) != 0) failed = TRUE;
    gboolean fine = failed ? fail(output->name, reason_of(output), error) : TRUE;
    g_clear_pointer(&output->name, g_free);
    return fine;
}

void tinker_output_clear(TinkerOutput *output)
{
    (void)tinker_output_close(output, NULL);
}

gboolean tinker_output_is_writable(const char *path, GError **error)
{
    if (access(path, F_OK) == 0) return access(path, W_OK) == 0 ? TRUE : fail(path, errno, error);
    g_autofree char *folder = g_path_get_dirname(path);
    return access(folder, W_OK | X_OK) == 0 ? TRUE : fail(path, errno, error);
}
