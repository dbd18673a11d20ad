/* How a scene answers to what drives it, a motor or a motion of a support, over its frequency, and whether it is driven
 * near a resonance. */
#ifndef TINKER_HOST_DRIVE_RESPONSE_H
#define TINKER_HOST_DRIVE_RESPONSE_H

#include "analysis/modes/mode-analysis.h"

typedef struct {
    char *drive, *quantity;    /* "Motor 0", "Mass 0.x": what answers most */
    char *unit;                /* "m/N" */
    GArray *hertz, *amplitude; /* of double: per unit of the drive; NAN where it has no bound */
    double driven;             /* Hz: of the drive as it is; NAN where it is no sine */
    double resonance;          /* Hz: the peak that it is near; NAN: none */
} TinkerDriveResponse;

/* Of every block that drives the scene, at most eight of them; element: TinkerDriveResponse *. The analysis is of the
 * scene. (transfer full) */
GPtrArray *tinker_drive_responses_new(const TinkerModeAnalysis *analysis, TinkerScene *scene);

/* "Motor 0 drives with 5.1 rad/s, near resonance at 5 rad/s", in the user's language; NULL where it is not near one.
 * (transfer full) */
char *tinker_drive_response_sentence(const TinkerDriveResponse *response);

/* "Near resonance at 5 rad/s (0.7958 Hz)", likewise: for where the drive and its frequency are shown already. */
char *tinker_drive_response_hint(const TinkerDriveResponse *response);

#endif
