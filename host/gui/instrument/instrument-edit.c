/* Each change puts another instrument in the place of one. */
#include "gui/instrument/instrument-edit.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/text/block-words.h"
#include "gui/text/translate.h"
#include "scene/store/quantities.h"

static const char *const kind_titles[] = {N_("Slider"), N_("Knob"), N_("Switch"),
                                          N_("Number"), N_("Dial"), N_("Level Bar")};

const char *tinker_instrument_kind_title(TinkerInstrumentKind kind)
{
    return _(kind_titles[kind]);
}

static const TinkerSceneInstrument *instrument_at(TinkerDocument *document, int number)
{
    return g_ptr_array_index(tinker_scene_instruments(tinker_document_scene(document)), (guint)number);
}

static gboolean set(TinkerDocument *document, int number, const TinkerSceneInstrument *instrument, const char *title,
                    const char *merge, GError **error)
{
    tinker_document_begin(document, title, merge);
    const gboolean good = tinker_history_set_instrument(tinker_document_history(document), number, instrument, error);
    if (good)
        tinker_document_end(document);
    else
        tinker_document_abort(document);
    return good;
}

static gboolean add(TinkerDocument *document, TinkerSceneInstrument *instrument, const TinkerInstrumentPlace *place,
                    const char *title, GError **error)
{
    const int last = (int)tinker_scene_instruments(tinker_document_scene(document))->len;
    instrument->has_place = place != NULL;
    if (place != NULL) memcpy(instrument->place, place->at, sizeof instrument->place);
    instrument->makes_way = place != NULL && place->makes_way;
    return set(document, last, instrument, title, NULL, error);
}

/* About the value that it has, up to twice as much; of one that is 0, the range that its block proposes. */
static void choose_range(const TinkerPropertyType *type, double value, double *from, double *to)
{
    const gboolean proposed = (type->flags & TINKER_HAS_SOFT_RANGE) != 0;
    const gboolean least = (type->flags & TINKER_HAS_MINIMUM) != 0, most = (type->flags & TINKER_HAS_MAXIMUM) != 0;
    const gboolean both = least && most;
    if (both || (value == 0 && proposed)) {
        *from = both ? type->hard_minimum : type->soft_minimum;
        *to = both ? type->hard_maximum : type->soft_maximum;
    } else {
        *from = value < 0 ? 2 * value : value == 0 && !least ? -1 : 0;
        *to = value > 0 ? 2 * value : value < 0 ? 0 : 1;
    }
    if (least && *from <= type->hard_minimum)
        *from = type->flags & TINKER_OPEN_MINIMUM ? type->hard_minimum + (*to - type->hard_minimum) / 20
                                                  : type->hard_minimum;
    if (most && *to >= type->hard_maximum)
        *to = type->flags & TINKER_OPEN_MAXIMUM ? type->hard_maximum - (type->hard_maximum - *from) / 20
                                                : type->hard_maximum;
}

/* The number that a few digits would be typed as. */
static double as_typed(double number)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    return g_ascii_strtod(g_ascii_formatd(text, sizeof text, "%.9g", number), NULL);
}

/* Steps of about a hundredth of the range, 1, 2 or 5 with noughts in the unit that is shown; and the range widened to
 * whole steps, but not beyond what is allowed. */
static void choose_step(const TinkerPropertyType *type, double per_si, TinkerSceneInstrument *control)
{
    const double from = control->from * per_si, to = control->to * per_si;
    const double rough = (to - from) / 100, ten = pow(10, floor(log10(rough))), share = rough / ten;
    const double step = as_typed((share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10) * ten);
    const gboolean least = (type->flags & TINKER_HAS_MINIMUM) != 0, most = (type->flags & TINKER_HAS_MAXIMUM) != 0;
    const double first = as_typed(from / step), last = as_typed(to / step);
    control->step = step / per_si;
    control->from = as_typed((least ? ceil(first) : floor(first)) * step) / per_si;
    control->to = as_typed((most ? floor(last) : ceil(last)) * step) / per_si;
}

/* What is shown of 1 in SI. */
static double shown_of_si(TinkerScene *scene, const TinkerSceneInstrument *control)
{
    TinkerUnit unit = {1, {0, 0, 0, 0}};
    tinker_unit_parse(tinker_instrument_unit(scene, control), &unit, NULL);
    return 1 / unit.factor;
}

gboolean tinker_control_add(TinkerDocument *document, TinkerBlockId block, const char *name,
                            const TinkerInstrumentPlace *place, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(TinkerSceneInstrument) control =
        tinker_scene_instrument_new(TINKER_INSTRUMENT_SLIDER, tinker_scene_block_name(scene, block), name);
    TinkerNumber number;
    if (tinker_scene_find_number(scene, block, name, &number)) {
        const double value = tinker_scene_get(scene, block, number.column);
        if (number.type->kind == TINKER_KIND_SWITCH)
            control->kind = TINKER_INSTRUMENT_SWITCH;
        else
            choose_range(number.type, isfinite(value) ? value : 1, &control->from, &control->to);
        if (number.type->kind == TINKER_KIND_INTEGER)
            control->step = 1;
        else if (number.type->kind != TINKER_KIND_SWITCH)
            choose_step(number.type, shown_of_si(scene, control), control);
    }
    return add(document, control, place, _("Add Control"), error);
}

gboolean tinker_meter_add(TinkerDocument *document, TinkerBlockId block, const char *quantity,
                          const TinkerInstrumentPlace *place, GError **error)
{
    TinkerScene *scene = tinker_document_scene(document);
    g_autoptr(TinkerSceneInstrument) meter =
        tinker_scene_instrument_new(TINKER_INSTRUMENT_NUMBER, tinker_scene_owner_name(scene, block), quantity);
    return add(document, meter, place, _("Add Meter"), error);
}

void tinker_instrument_remove(TinkerDocument *document, int number)
{
    const gboolean controls = tinker_instrument_controls(instrument_at(document, number));
    set(document, number, NULL, controls ? _("Delete Control") : _("Delete Meter"), NULL, NULL);
}

void tinker_instrument_move(TinkerDocument *document, int number, const double place[2], const char *merge)
{
    TinkerSceneInstrument moved = *instrument_at(document, number); /* the texts are copied by the history */
    moved.has_place = TRUE;
    moved.makes_way = FALSE;
    memcpy(moved.place, place, sizeof moved.place);
    set(document, number, &moved, tinker_instrument_controls(&moved) ? _("Move Control") : _("Move Meter"), merge,
        NULL);
}

void tinker_instrument_set_kind(TinkerDocument *document, int number, TinkerInstrumentKind kind)
{
    TinkerSceneInstrument changed = *instrument_at(document, number);
    if (changed.kind == kind) return;
    changed.kind = kind;
    set(document, number, &changed, tinker_instrument_controls(&changed) ? _("Change Control") : _("Change Meter"),
        NULL, NULL);
}

gboolean tinker_instrument_set_range(TinkerDocument *document, int number, double from, double to, double step,
                                     GError **error)
{
    TinkerSceneInstrument changed = *instrument_at(document, number);
    changed.from = from;
    changed.to = to;
    changed.step = step;
    return set(document, number, &changed, _("Change Control"), NULL, error);
}

/* Words ------------------------------------------------------------------------------------------------------------ */

/* What is known of the number or quantity; FALSE of a block whose type nobody provides. */
static gboolean describe(const TinkerScene *scene, const TinkerSceneInstrument *instrument, TinkerBlockId *block,
                         const char **title, TinkerDimension *dimension)
{
    TinkerNumber number;
    if (!tinker_scene_find_owner(scene, instrument->block, block)) return FALSE;
    if (tinker_instrument_controls(instrument)) {
        if (!tinker_scene_find_number(scene, *block, instrument->of, &number)) return FALSE;
        *title = number.type->title;
        *dimension = number.type->dimension;
        return TRUE;
    }
    const int32_t quantity = tinker_scene_find_quantity(scene, *block, instrument->of);
    if (quantity < 0) return FALSE;
    const TinkerQuantityType type = tinker_scene_quantity_type(scene, *block, quantity);
    *title = type.title;
    *dimension = type.dimension;
    return TRUE;
}

char *tinker_instrument_title(const TinkerScene *scene, const TinkerSceneInstrument *instrument)
{
    TinkerBlockId block;
    TinkerDimension dimension;
    const char *title = instrument->of;
    describe(scene, instrument, &block, &title, &dimension);
    TinkerNumber number;
    const gboolean is_number = tinker_instrument_controls(instrument) &&
                               tinker_scene_find_owner(scene, instrument->block, &block) &&
                               tinker_scene_find_number(scene, block, instrument->of, &number);
    g_autofree char *words =
        is_number ? tinker_property_words(number.type, number.component) : g_strdup(tinker_translate(title));
    const gboolean of_scene = g_str_equal(instrument->block, "Scene");
    return g_strdup_printf("%s: %s", of_scene ? _("Scene") : instrument->block, words);
}

const char *tinker_instrument_unit(TinkerScene *scene, const TinkerSceneInstrument *instrument)
{
    TinkerBlockId block;
    const char *title;
    TinkerDimension dimension;
    if (!describe(scene, instrument, &block, &title, &dimension)) return "";
    const TinkerUnitSystem system = tinker_scene_head(scene)->units;
    if (block == TINKER_NO_BLOCK) return tinker_unit_for(dimension, system);
    g_autofree char *id = g_strdup(instrument->of);
    if (tinker_instrument_controls(instrument) && strchr(id, '.') != NULL) *strchr(id, '.') = '\0';
    return tinker_block_class_unit(tinker_scene_block_class(scene, block), id, dimension,
                                   system == TINKER_UNIT_SYSTEM_ENGLISH);
}
