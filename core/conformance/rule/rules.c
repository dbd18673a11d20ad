/* The rules: their names, what they hold, and who tries them. docs/reference/plugin-checks.md explains each. */
#include "conformance/probe/kit.h"
#include "conformance/rule/conformance.h"

static void try_descriptor(KitCheck *check) {} // opening the library has made all of its checks

static const KitRule rules[] = {
    {{"descriptor", "The library opens and its descriptor passes all checks of the host"}, try_descriptor, NULL, NULL},
    {{"symbols", "It exports its entry alone and links to nothing of Tinker's"}, kit_try_symbols, NULL, NULL},
    {{"declaration", "Texts are there, titles differ, symbols differ, ids are plain, ranges hold one another"},
     kit_try_library_declaration,
     kit_try_declaration,
     kit_try_method_declaration},
    {{"batches", "A whole batch, its slices, single instances and a repeated call give the same bits"},
     NULL,
     kit_try_batches,
     kit_try_method_same_bits},
    {{"finite", "Results are finite, or refused in words, also at zero length, tiny, huge and limiting values"},
     NULL,
     kit_try_finite,
     NULL},
    {{"momentum", "Internal forces sum to zero"}, NULL, kit_try_momentum, NULL},
    {{"moment", "Internal forces give no moment"}, NULL, kit_try_moment, NULL},
    {{"translation", "What acts within a scene is the same wherever the scene is"}, NULL, kit_try_translation, NULL},
    {{"rotation", "What acts within a scene turns with the scene"}, NULL, kit_try_rotation, NULL},
    {{"coupling", "A field whose force on a body depends on other bodies says so"}, NULL, kit_try_coupling, NULL},
    {{"energy", "Force is minus the gradient of the stored energy"}, NULL, kit_try_energy, NULL},
    {{"passive", "What depends on velocity takes energy, and gives none"}, NULL, kit_try_passive, NULL},
    {{"derivatives", "Derivatives agree with finite differences of the force"}, NULL, kit_try_derivatives, NULL},
    {{"jacobian", "A constraint's Jacobian agrees with finite differences of its rows"}, NULL, kit_try_jacobian, NULL},
    {{"drift", "A constraint's drift and prescribed rate agree with differences along a motion"},
     NULL,
     kit_try_drift,
     NULL},
    {{"motion", "Velocity and acceleration of a motion are the derivatives of its displacement"},
     NULL,
     kit_try_motion,
     NULL},
    {{"linear", "The linear form, that of distances or of ends that coincide, says the same as the general functions"},
     NULL,
     kit_try_linear,
     NULL},
    {{"law", "The law that it states as data says what its code does, in units that go together"},
     NULL,
     kit_try_law,
     NULL},
    {{"breaks", "Each next break lies strictly later than the time it is asked for"}, NULL, kit_try_breaks, NULL},
    {{"dimensions", "In other units of mass, length and time results change as their dimensions say"},
     NULL,
     kit_try_dimensions,
     NULL},
    {{"memory", "Nothing is written beyond a result, or to an input"}, NULL, kit_try_memory, NULL},
    {{"process", "Locale, umask, the mode of floating-point numbers and handlers of signals stay as they are"},
     kit_try_library_process,
     kit_try_process,
     NULL},
    {{"quiet", "Inside a step nothing is allotted, locked, printed or read"},
     NULL,
     kit_try_quiet,
     kit_try_method_quiet},
    {{"bounds", "The drawing stays inside its declared bounds"}, NULL, kit_try_bounds, NULL},
    {{"hit", "What is drawn can be hit, and what is far from it cannot"}, NULL, kit_try_hit, NULL},
    {{"run", "A small scene with the block runs, and its record is finite"}, NULL, kit_try_run, NULL},
    {{"saved", "A saved and loaded scene runs to the same bits"}, NULL, kit_try_saved, NULL},
    {{"order", "Halving the step shrinks the error as the declared order says"}, NULL, NULL, kit_try_method_order},
    {{"steps", "Steps land where they should, and dense output fits their ends"}, NULL, NULL, kit_try_method_steps},
    {{"limits", "Steps are stable up to the declared limits, and not far beyond"}, NULL, NULL, kit_try_method_limits},
    {{"constrained", "A step of a pendulum ends with its rod as long as it was"},
     NULL,
     NULL,
     kit_try_method_constrained},
    {{"speed", "How long an element takes; for information"}, NULL, kit_try_speed, kit_try_method_speed},
    {{NULL, NULL}, NULL, NULL, NULL},
};

const KitRule *kit_rule(gsize number)
{
    return &rules[number];
}

const TinkerConformanceRule *tinker_conformance_rules(void)
{
    static TinkerConformanceRule list[G_N_ELEMENTS(rules)];
    for (gsize i = 0; i < G_N_ELEMENTS(rules); i++)
        list[i] = rules[i].rule;
    return list;
}
