#include "units/expression/waveform-error.h"

G_DEFINE_QUARK(tinker_waveform_error_quark, tinker_waveform_error)
