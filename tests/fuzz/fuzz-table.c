/* Tables in files: the first byte chooses column, scale and kind, the rest is the file. What was read is evaluated
 * before, between and behind its rows. */
#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

#include "fuzz-target.h"
#include "units/waveform/waveform.h"

/* The bytes as a file; its path. (transfer full) */
static char *file_of(const uint8_t *data, size_t size)
{
    static int file = -1;
    if (file < 0) file = memfd_create("table", MFD_CLOEXEC);
    if (file < 0 || ftruncate(file, 0) != 0 || pwrite(file, data, size, 0) != (gssize)size)
        g_error("no file in memory could be written");
    return g_strdup_printf("/proc/self/fd/%d", file);
}

static void check(TinkerWaveform *waveform, gboolean smooth)
{
    static const double times[] = {-1e300, -1, 0, 0.3, 1, 2.5, 1e6, 1e300};
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveform, 1, 1, 0, smooth);
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        double result[3];
        tinker_waveform_enter_piece(evaluator, times[i]);
        tinker_waveform_evaluate(evaluator, times[i], result);
        const double next = tinker_waveform_next_break(evaluator, times[i], INFINITY);
        if (!(next > times[i])) g_error("the break after %.17g is %.17g", times[i], next);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0) return 0;
    const int column = data[0] % 4;
    const double scale = data[0] & 16 ? 1e200 : 1.5;
    const TinkerTableKind kind = data[0] & 32 ? TINKER_TABLE_ACCELERATION : TINKER_TABLE_VALUE;
    g_autofree char *path = file_of(data + 1, size - 1);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_table_file(path, column, scale, kind, &error);
    if (waveform == NULL) {
        if (error == NULL || !g_str_has_prefix(error->message, path)) g_error("the message does not name the file");
        return 0;
    }
    check(waveform, FALSE);
    check(waveform, kind == TINKER_TABLE_VALUE);
    return 0;
}
