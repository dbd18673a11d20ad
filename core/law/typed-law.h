/* Laws that the user types (tinker/typed-law.h): read, with the numbers that they name, and compiled. */
#ifndef TINKER_CORE_TYPED_LAW_H
#define TINKER_CORE_TYPED_LAW_H

#include "plugin/catalogue/catalogue.h"
#include "units/compiled/compiled.h"

/* The text of one of the block's properties; "" where it is empty. Borrowed. */
typedef const char *(*TinkerTypedLawTextFunc)(int32_t property, void *data);

/* A number with any unit, "3 N/m" or "3", in SI. */
gboolean tinker_any_quantity_parse(const char *text, double *si, TinkerDimension *dimension, GError **error);

/* The expression of a property with TINKER_TEXT_LAW, over its arguments and the ids of the block's numbers. Errors
 * say what is wrong with the text. (transfer full) */
TinkerExpression *tinker_typed_parse(const TinkerBlockClass *block_class, int32_t property, const char *text,
                                     GError **error);

/* Compiled with the numbers that it names, and with its derivatives. Errors besides: a number that is missing or cannot
 * be read. (transfer full: tinker_typed_free) */
TinkerTypedLaw *tinker_typed_new(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                                 void *data, GError **error);
/* Tells each law of a block how to find what it does to energy (laws in the order of their properties; NULL: an empty
 * text). A tension that does not depend on t stores the integral of what it is at rest: by its antiderivative, or where
 * the grammar has none by a sum from 1 m on, if it is a number from 1/16 to 16 m. A force_x and a force_y store
 * together minus that of what they are at rest, where it is one of places alone and has an antiderivative; the first of
 * them is told. A potential stores what it is. */
void tinker_typed_set_energies(const TinkerBlockClass *block_class, TinkerTypedLaw *const *laws);
/* Where the units do not come out as the law's: "tension is in kg/m where N was expected: taken in SI". NULL: they do,
 * or nothing is typed. (transfer full) */
char *tinker_typed_note(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                        void *data);

#endif
