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
/* Where the units do not come out as the law's: "tension is in kg/m where N was expected: taken in SI". NULL: they do,
 * or nothing is typed. (transfer full) */
char *tinker_typed_note(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                        void *data);

#endif
