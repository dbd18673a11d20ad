/* The frequency response of `tinker modes --response`: worked out, drawn, written. */
#ifndef TINKER_CLI_MODE_RESPONSE_H
#define TINKER_CLI_MODE_RESPONSE_H

#include "analysis/modes/mode-analysis.h"
#include "render/draw/theme.h"

typedef struct {
    const char *input;  /* a block's name */
    const char *output; /* a column's */
    double from, to;    /* rad/s; 0: around the modes */
    int points;
    gboolean linear; /* axes of frequency and amplitude; else logarithmic */
} TinkerModeResponseWish;

typedef struct {
    TinkerLinearInput input;
    TinkerLinearOutput output;
    GArray *columns; /* of TinkerColumn: the output alone */
    TinkerFrequencyResponse *response;
    GArray *grid;              /* of double: rad/s */
    GArray *amplitude, *phase; /* of double: per unit of the input; degrees, NaN where the amplitude is not finite */
    GArray *peaks;             /* of TinkerResponsePeak */
    char *name;                /* "Mass 0.x per Motor 0" */
    char *unit;                /* "m/N" */
    gboolean linear;
} TinkerModeResponse;

/* Errors: TINKER_CLI_ERROR_USAGE for names that are none, TINKER_MODEL_ERROR_RUN. Clear it either way. */
gboolean tinker_mode_response_make(TinkerModeResponse *made, const TinkerModeAnalysis *analysis, TinkerScene *scene,
                                   const TinkerModeResponseWish *wish, GError **error);
void tinker_mode_response_clear(TinkerModeResponse *made);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerModeResponse, tinker_mode_response_clear)

/* Amplitude above phase, peaks pointed out, to .png, .svg or .pdf. */
gboolean tinker_mode_response_draw(const TinkerModeResponse *made, const TinkerTheme *theme, int width, int height,
                                   const char *path, GError **error);

/* "frequency [Hz],amplitude [m/N],phase [deg]"; `path` may be "-". */
gboolean tinker_mode_response_write_csv(const TinkerModeResponse *made, const char *path, GError **error);

#endif
