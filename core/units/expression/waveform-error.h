/* What can be wrong with the text of an expression, and with a table. */
#ifndef TINKER_CORE_WAVEFORM_ERROR_H
#define TINKER_CORE_WAVEFORM_ERROR_H

#include <glib.h>

typedef enum {
    TINKER_WAVEFORM_ERROR_SYNTAX,
    TINKER_WAVEFORM_ERROR_UNKNOWN_NAME,
    TINKER_WAVEFORM_ERROR_TABLE,
    TINKER_WAVEFORM_ERROR_FILE,
} TinkerWaveformError;
#define TINKER_WAVEFORM_ERROR (tinker_waveform_error_quark())
GQuark tinker_waveform_error_quark(void);

#endif
