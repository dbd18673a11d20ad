/* The law of a block type as lines of text, for who looks for a block: made from what it states (tinker/law.h). */
#ifndef TINKER_CORE_LAW_TEXT_H
#define TINKER_CORE_LAW_TEXT_H

#include "plugin/catalogue/catalogue.h"

/* "T = k (L − L0)", "V = k (L − L0)² / 2": an equation a line, of a block with all ends that it can have. The symbols
 * are those of a page of equations, without the numbers of blocks: T a tension, V a potential, F a force, M a torque, a
 * dot a derivative by time, x₁(0) a place at the start. A law that is typed names what it may depend on: "T = T(L, L̇,
 * t)". Of a body it is Newton's. A block that acts and states no law, or one that cannot be read, has the name of its
 * force alone, "F_Title". No line of what does nothing, and of a support. (transfer full) */
char **tinker_class_law_lines(const TinkerBlockClass *block_class);

#endif
