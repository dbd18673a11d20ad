#include "units/expression/waveform-error.h"

GQuark tinker_waveform_error_quark(void)
{
    return g_quark_from_static_string("tinker-waveform-error-quark");
}
