/* Outputs: opening early, closing with all errors told. */
#include "output.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "exit-status.h"

gboolean tinker_is_standard_stream(const char *path)
{
    return path != NULL && strcmp(path, "-") == 0;
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

static gboolean same_file(const char *a, const char *b)
{
    struct stat first, second;
    return stat(a, &first) == 0 && stat(b, &second) == 0 && first.st_dev == second.st_dev &&
           first.st_ino == second.st_ino && S_ISREG(first.st_mode);
}

gboolean tinker_output_open(TinkerOutput *output, const char *path, const char *input, GError **error)
{
    if (tinker_is_standard_stream(path)) {
        output->file = stdout;
        output->name = g_strdup("standard output");
        return TRUE;
    }
    if (input != NULL && !tinker_is_standard_stream(input) && same_file(path, input)) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "%s: is the scene itself; choose another output",
                    path);
        return FALSE;
    }
    output->file = fopen(path, "we");
    if (output->file == NULL) return fail(path, errno, error);
    output->name = g_strdup(path);
    return TRUE;
}

static int reason_of(const TinkerOutput *output)
{
    if (output->reason != 0) return output->reason;
    return errno != 0 ? errno : EIO;
}

void tinker_output_flush(TinkerOutput *output, const char *text, gsize size)
{
    errno = 0;
    const gboolean fine = fwrite(text, 1, size, output->file) == size && fflush(output->file) == 0;
    if (!fine && output->reason == 0) output->reason = errno;
}

gboolean tinker_output_check(const TinkerOutput *output, GError **error)
{
    return ferror(output->file) ? fail(output->name, reason_of(output), error) : TRUE;
}

gboolean tinker_output_close(TinkerOutput *output, GError **error)
{
    if (output->file == NULL) return TRUE;
    FILE *file = output->file;
    output->file = NULL;
    int failed = ferror(file);
    errno = 0;
    if ((file == stdout ? fflush(file) : fclose(file)) != 0) failed = 1;
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
