/* What the tests of contact share: the methods and what each may be off, events, and what friction and impacts took.
 *
 * Blocks of scenes as physics-fixture.h has them. A floor's top lies at y = 0 where it is put at y = -0.2.
 */
#ifndef TEST_CONTACT_CHECKS_H
#define TEST_CONTACT_CHECKS_H

#include "physics-fixture.h"

#define CONTACT_GRAVITY 9.81
#define CONTACT_WEIGHT  "{'type': 'gravity'},"
#define CONTACT_SMOOTH  "'static_friction': 0, 'dynamic_friction': 0"
/* The start of a mass without extent, and of a support of the usual 0.4 m. */
#define CONTACT_POINT "{'type': 'mass', 'width': 0, 'height': 0"
#define CONTACT_FLOOR "{'type': 'support', 'position': [0, -0.2]"

typedef struct {
    const char *method;
    double step;       /* s; 0 for adaptive ones, which run at a tolerance of 1e-11 */
    double polynomial; /* what a motion at constant acceleration may be off, m and m/s */
    double smooth;     /* what oscillations of some 10 rad/s may be off within a second or two */
} ContactMethod;

enum { CONTACT_METHODS = 7 };
extern const ContactMethod contact_methods[CONTACT_METHODS]; /* the first one is auto */

PhysicsOptions contact_options(const ContactMethod *method, double duration, const char *columns);

/* An event of this kind, of these blocks ("Mass 0, Support 0"; NULL: any), happened at this time. */
void contact_assert_event(const PhysicsRun *run, const char *kind, const char *blocks, double time, double bound);
void contact_assert_count(const PhysicsRun *run, const char *kind, int count);
/* The one of this kind that is nearest to this time, and hardly away from it; NULL for none. (transfer none) */
const TinkerEvent *contact_event_at(const PhysicsRun *run, const char *kind, double time);

void contact_assert_state(const PhysicsRun *run, const char *mass, const double state[4], double bound);

/* The books close, and sliding and impacts took this much (J, not negative). What an impact takes along the top counts
 * as an impact's. */
void contact_assert_taken(const PhysicsRun *run, double friction, double impacts, double bound);

/* A support turned by `angle` whose top's middle is the point (x, y); `more` holds further members, or is empty.
 * (transfer full) */
char *contact_plate(double x, double y, double angle, double width, const char *more);

/* Contact as impulses, in ever shorter steps, comes near the motion by events: places by `slope` times the step at the
 * most, at all samples; what constraints hold is held to rounding. */
void contact_check_converges(const char *blocks, const char *columns, double duration, double coarsest, double slope);

/* Where f changes its sign between two times, by bisection. */
double contact_bisect(double from, double to, double (*f)(double t, const void *data), const void *data);

#endif
