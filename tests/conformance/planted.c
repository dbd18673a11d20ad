/* One good library, and with PLANT_... defined the same with one fault. It has line laws (pull, rub), force elements
 * (pair, follow, knock, clap), a field (gather), a body (ball), constraints (keep, hold), a motion (sway) and an
 * integrator (simple): those of the parts for which LISTS_... is defined, as each that is listed takes its time to
 * check. */
#include <locale.h>
#include <sys/stat.h>

#include "planted.h"

#ifdef PLANT_exports
TINKER_EXPORT int another_symbol(void);
int another_symbol(void)
{
    return 1;
}
#endif

#if defined(PLANT_counts) || defined(PLANT_counts_rows)
double planted_prepared;
TinkerStatus planted_prepare(TinkerBatch *batch)
{
    planted_prepared++;
    return TINKER_OK;
}
#elif defined(PLANT_prepares_umask)
TinkerStatus planted_prepare(TinkerBatch *batch)
{
    umask(0);
    return TINKER_OK;
}
#endif

#ifdef PLANT_opens_locale
__attribute__((constructor)) static void change_locale(void)
{
    setlocale(LC_NUMERIC, "C.UTF-8");
}
#endif

#if defined(PLANT_type_id)
#define FOLLOW_ID "Planted Follow"
#else
#define FOLLOW_ID "planted-follow"
#endif
#if defined(PLANT_plugin_id)
#define PLUGIN_ID "planted"
#else
#define PLUGIN_ID "org.example.planted"
#endif
#if defined(PLANT_version)
#define VERSION "one"
#else
#define VERSION "1.0.0"
#endif

#if defined(PLANTED_LAW)
#define PULL_LAW_SPAN TINKER_SPAN(planted_pull_law)
#else
#define PULL_LAW_SPAN TINKER_NO_SPAN
#endif

#define ANY (TINKER_ACCEPTS_BODY | TINKER_ACCEPTS_SUPPORT)
static const TinkerBlockType blocks[] = {
#ifdef LISTS_pull
    {TINKER_BLOCK("planted-pull", "Pull", TINKER_CONNECTOR), .summary = "Pulls", .least_ends = 2, .most_ends = 2,
     .end_accepts = ANY, .properties = TINKER_SPAN(planted_pull_properties),
     .quantities = TINKER_SPAN(planted_quantities), .interfaces = TINKER_SPAN(planted_pull_interfaces),
     .law = PULL_LAW_SPAN},
#endif
#ifdef LISTS_rub
    {TINKER_BLOCK("planted-rub", "Rub", TINKER_CONNECTOR), .summary = "Touches and rubs", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(planted_rub_properties),
     .interfaces = TINKER_SPAN(planted_rub_interfaces)},
#endif
#ifdef LISTS_knock
    {TINKER_BLOCK("planted-knock", "Knock", TINKER_FORCE), .summary = "A blow", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(planted_knock_properties),
     .interfaces = TINKER_SPAN(planted_knock_interfaces), .law = TINKER_SPAN(planted_knock_law)},
    {TINKER_BLOCK("planted-clap", "Clap", TINKER_CONNECTOR), .summary = "Blows at both ends", .least_ends = 2,
     .most_ends = 2, .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(planted_knock_properties),
     .interfaces = TINKER_SPAN(planted_clap_interfaces)},
#endif
#ifdef LISTS_forces
    {TINKER_BLOCK("planted-pair", "Pair", TINKER_CONNECTOR), .summary = "Pulls two together", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(planted_pull_properties),
     .interfaces = TINKER_SPAN(planted_pair_interfaces)},
    {TINKER_BLOCK(FOLLOW_ID, "Follow", TINKER_FORCE), .summary = "A jet", .least_ends = 2, .most_ends = 2,
     .end_accepts = ANY, .properties = TINKER_SPAN(planted_follow_properties),
     .interfaces = TINKER_SPAN(planted_follow_interfaces)},
    {TINKER_BLOCK("planted-gather", "Gather", TINKER_FIELD), .summary = "Draws all together",
     .properties = TINKER_SPAN(planted_gather_properties), .interfaces = TINKER_SPAN(planted_gather_interfaces)},
#endif
    {TINKER_BLOCK("planted-ball", "Ball", TINKER_CONNECTABLE), .summary = "A point with a mass",
     .properties = TINKER_SPAN(planted_ball_properties), .interfaces = TINKER_SPAN(planted_ball_interfaces)},
#ifdef LISTS_constraints
    {TINKER_BLOCK("planted-keep", "Keep", TINKER_CONNECTOR), .summary = "Keeps a distance", .least_ends = 2,
     .most_ends = 2, .end_accepts = ANY, .properties = TINKER_SPAN(planted_keep_properties),
     .interfaces = TINKER_SPAN(planted_keep_interfaces)},
    {TINKER_BLOCK("planted-hold", "Hold", TINKER_CONNECTOR), .summary = "Holds a body", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_BODY, .properties = TINKER_SPAN(planted_hold_properties),
     .interfaces = TINKER_SPAN(planted_hold_interfaces)},
    {TINKER_BLOCK("planted-sway", "Sway", TINKER_MOTION), .summary = "Sways", .least_ends = 1, .most_ends = 1,
     .end_accepts = TINKER_ACCEPTS_SUPPORT, .properties = TINKER_SPAN(planted_sway_properties),
     .interfaces = TINKER_SPAN(planted_sway_interfaces)},
#endif
};

#ifdef LISTS_method
#define INTEGRATORS TINKER_SPAN(planted_integrators)
#else
#define INTEGRATORS TINKER_NO_SPAN
#endif

static const TinkerPlugin plugin = {TINKER_PLUGIN_HEAD,  PLUGIN_ID,   "Planted",      VERSION, "MIT", "",
                                    TINKER_SPAN(blocks), INTEGRATORS, TINKER_NO_SPAN, NULL};
const TinkerPlugin *tinker_plugin_v1(void)
{
    return &plugin;
}
