/* The themes are data. Colours of curves are those of Okabe and Ito, "Color Universal Design" (2008), which people with
 * the common kinds of colour blindness tell apart; their yellow is replaced where the background is white, their black
 * where it is dark. Where contrast comes first, their hues are kept and their lightness spread. */
#include "render/draw/theme.h"

/* A colour as it is written on the web. */
#define RGBA(hex, alpha)                                                                                               \
    {                                                                                                                  \
        ((hex) >> 16 & 0xff) / 255.0, ((hex) >> 8 & 0xff) / 255.0, ((hex)&0xff) / 255.0, alpha                         \
    }
#define RGB(hex) RGBA(hex, 1.0)

static const TinkerTheme themes[] = {
    {
        .id = "light",
        .background = RGB(0xffffff),
        .grid = RGB(0xe6e8eb),
        .axis = RGB(0x3d3d3d),
        .colours =
            {
                [TINKER_COLOUR_BODY] = RGB(0xd6e4f2),
                [TINKER_COLOUR_BODY_EDGE] = RGB(0x27496d),
                [TINKER_COLOUR_SUPPORT] = RGB(0xd3d0c8),
                [TINKER_COLOUR_CONNECTOR] = RGB(0x000000),
                [TINKER_COLOUR_COMPRESSED] = RGB(0xd0101b),
                [TINKER_COLOUR_STRETCHED] = RGB(0x1244d6),
                [TINKER_COLOUR_DETACHED] = RGB(0x767676),
                [TINKER_COLOUR_SELECTED] = RGB(0x3584e4),
                [TINKER_COLOUR_HIGHLIGHTED] = RGB(0x26a269),
                [TINKER_COLOUR_WARNING] = RGB(0xb5178f),
                [TINKER_COLOUR_FORCE] = RGB(0xe66100),
                [TINKER_COLOUR_MOTION] = RGB(0x0b8a8a),
                [TINKER_COLOUR_FIELD] = RGB(0x6a4fb8),
                [TINKER_COLOUR_TEXT] = RGB(0x1f1f1f),
            },
        .curves = {RGB(0x0072b2), RGB(0xd55e00), RGB(0x009e73), RGB(0xcc79a7), RGB(0xe69f00), RGB(0x56b4e9),
                   RGB(0x000000), RGB(0x8c6d31)},
    },
    {
        .id = "dark",
        .background = RGB(0x1e1e1e),
        .grid = RGB(0x343434),
        .axis = RGB(0xc8c8c8),
        .colours =
            {
                [TINKER_COLOUR_BODY] = RGB(0x33495f),
                [TINKER_COLOUR_BODY_EDGE] = RGB(0xa9c8e8),
                [TINKER_COLOUR_SUPPORT] = RGB(0x55524b),
                [TINKER_COLOUR_CONNECTOR] = RGB(0xffffff),
                [TINKER_COLOUR_COMPRESSED] = RGB(0xff5a52),
                [TINKER_COLOUR_STRETCHED] = RGB(0x62a0ff),
                [TINKER_COLOUR_DETACHED] = RGB(0x909090),
                [TINKER_COLOUR_SELECTED] = RGB(0x78aeed),
                [TINKER_COLOUR_HIGHLIGHTED] = RGB(0x57e389),
                [TINKER_COLOUR_WARNING] = RGB(0xf06fd0),
                [TINKER_COLOUR_FORCE] = RGB(0xffa348),
                [TINKER_COLOUR_MOTION] = RGB(0x4fd0d0),
                [TINKER_COLOUR_FIELD] = RGB(0xb7a0f5),
                [TINKER_COLOUR_TEXT] = RGB(0xeeeeee),
            },
        .curves = {RGB(0x56b4e9), RGB(0xe7654d), RGB(0x1ce994), RGB(0xca91b3), RGB(0xedaf00), RGB(0x858cff),
                   RGB(0xf2f2f2), RGB(0xd6ca5c)},
    },
    {
        .id = "print",
        .background = RGB(0xffffff),
        .grid = RGB(0xdcdcdc),
        .axis = RGB(0x000000),
        .colours =
            {
                [TINKER_COLOUR_BODY] = RGB(0xececec),
                [TINKER_COLOUR_BODY_EDGE] = RGB(0x000000),
                [TINKER_COLOUR_SUPPORT] = RGB(0xd4d4d4),
                [TINKER_COLOUR_CONNECTOR] = RGB(0x000000),
                [TINKER_COLOUR_COMPRESSED] = RGB(0xc00010),
                [TINKER_COLOUR_STRETCHED] = RGB(0x0033c0),
                [TINKER_COLOUR_DETACHED] = RGB(0x707070),
                [TINKER_COLOUR_SELECTED] = RGB(0x3584e4),
                [TINKER_COLOUR_HIGHLIGHTED] = RGB(0x26a269),
                [TINKER_COLOUR_WARNING] = RGB(0x9a0f78),
                [TINKER_COLOUR_FORCE] = RGB(0xe06c00),
                [TINKER_COLOUR_MOTION] = RGB(0x006f6f),
                [TINKER_COLOUR_FIELD] = RGB(0x553c9a),
                [TINKER_COLOUR_TEXT] = RGB(0x000000),
            },
        .curves = {RGB(0x0072b2), RGB(0xd55e00), RGB(0x009e73), RGB(0xcc79a7), RGB(0xe69f00), RGB(0x56b4e9),
                   RGB(0x000000), RGB(0x8c6d31)},
    },
    {
        .id = "contrast-light",
        .background = RGB(0xffffff),
        .grid = RGB(0xc8c8c8),
        .axis = RGB(0x000000),
        .colours =
            {
                [TINKER_COLOUR_BODY] = RGB(0xe6eef8),
                [TINKER_COLOUR_BODY_EDGE] = RGB(0x000000),
                [TINKER_COLOUR_SUPPORT] = RGB(0xcccccc),
                [TINKER_COLOUR_CONNECTOR] = RGB(0x000000),
                [TINKER_COLOUR_COMPRESSED] = RGB(0xa8000d),
                [TINKER_COLOUR_STRETCHED] = RGB(0x0030b0),
                [TINKER_COLOUR_DETACHED] = RGB(0x595959),
                [TINKER_COLOUR_SELECTED] = RGB(0x0b57b8),
                [TINKER_COLOUR_HIGHLIGHTED] = RGB(0x0f6b3c),
                [TINKER_COLOUR_WARNING] = RGB(0x84006a),
                [TINKER_COLOUR_FORCE] = RGB(0xa04000),
                [TINKER_COLOUR_MOTION] = RGB(0x005858),
                [TINKER_COLOUR_FIELD] = RGB(0x3f2a86),
                [TINKER_COLOUR_TEXT] = RGB(0x000000),
            },
        .curves = {RGB(0x2030ca), RGB(0xc84e00), RGB(0x055041), RGB(0xb74f88), RGB(0x5d3604), RGB(0x2b7ac2),
                   RGB(0x000000), RGB(0x8b7048)},
    },
    {
        .id = "contrast-dark",
        .background = RGB(0x000000),
        .grid = RGB(0x4a4a4a),
        .axis = RGB(0xffffff),
        .colours =
            {
                [TINKER_COLOUR_BODY] = RGB(0x1d3a57),
                [TINKER_COLOUR_BODY_EDGE] = RGB(0xffffff),
                [TINKER_COLOUR_SUPPORT] = RGB(0x4d4d4d),
                [TINKER_COLOUR_CONNECTOR] = RGB(0xffffff),
                [TINKER_COLOUR_COMPRESSED] = RGB(0xff8078),
                [TINKER_COLOUR_STRETCHED] = RGB(0x7fb2ff),
                [TINKER_COLOUR_DETACHED] = RGB(0xb0b0b0),
                [TINKER_COLOUR_SELECTED] = RGB(0x66b3ff),
                [TINKER_COLOUR_HIGHLIGHTED] = RGB(0x6cf09b),
                [TINKER_COLOUR_WARNING] = RGB(0xff8ae2),
                [TINKER_COLOUR_FORCE] = RGB(0xffb357),
                [TINKER_COLOUR_MOTION] = RGB(0x5fe0e0),
                [TINKER_COLOUR_FIELD] = RGB(0xcbb8ff),
                [TINKER_COLOUR_TEXT] = RGB(0xffffff),
            },
        .curves = {RGB(0x94b4f7), RGB(0xff625b), RGB(0x52ffb2), RGB(0xc88eae), RGB(0xd68809), RGB(0x9f80ff),
                   RGB(0xffffff), RGB(0xf9de57)},
    },
};

const TinkerTheme *tinker_theme_find(const char *id)
{
    for (gsize i = 0; id && i < G_N_ELEMENTS(themes); i++)
        if (!g_strcmp0(themes[i].id, id)) return &themes[i];
    return NULL;
}

const char *const *tinker_theme_ids(void)
{
    static const char *const ids[] = {"light", "dark", "print", "contrast-light", "contrast-dark", NULL};
    return ids;
}
