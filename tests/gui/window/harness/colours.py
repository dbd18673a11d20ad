"""Which colours are in a picture. Lines are smoothed, so a pixel counts for a colour when it is mostly that colour over the
background."""

BACKGROUND = (255, 255, 255)

# Of the light theme, by what they mean; core/render/draw/theme.c.
CONNECTOR = (0x00, 0x00, 0x00)
COMPRESSED = (0xd0, 0x10, 0x1b)
STRETCHED = (0x12, 0x44, 0xd6)
DETACHED = (0x76, 0x76, 0x76)
SELECTED = (0x35, 0x84, 0xe4)
HIGHLIGHTED = (0x26, 0xa2, 0x69)
FORCE = (0xe6, 0x61, 0x00)
BODY = (0xd6, 0xe4, 0xf2)
FIELD = (0x6a, 0x4f, 0xb8)
NORMAL = (0x00, 0x9e, 0x73)  # of arrows of forces; core/render/picture/arrows-key.c
CURVE = (0x00, 0x72, 0xb2)  # the first of a plot


def share_of(pixel, colour, background=BACKGROUND):
    """How much of the colour lies over the background, or None where the pixel is no mixture of the two."""
    way = [c - b for c, b in zip(colour, background)]
    off = [p - b for p, b in zip(pixel, background)]
    share = sum(w * o for w, o in zip(way, off)) / sum(w * w for w in way)
    rest = sum((o - share * w) ** 2 for w, o in zip(way, off))
    return share if rest <= 30 ** 2 else None


def fill_count(picture, box, colour):
    """How many pixels in the box are of the colour alone, as in the inside of an area."""
    return sum(1 for pixel in picture.pixels(box) if max(abs(p - c) for p, c in zip(pixel, colour)) <= 3)


def count(picture, box, colour, least=0.6, most=1.2, background=BACKGROUND):
    """How many pixels in the box are of the colour."""
    shares, number = {}, 0
    for pixel in picture.pixels(box):
        if pixel not in shares:
            share = share_of(pixel, colour, background)
            shares[pixel] = share is not None and least <= share <= most
        number += shares[pixel]
    return number


def places(picture, box, colour, least=0.6, most=1.2):
    """(x, y) of all such pixels."""
    x0, y0, x1, y1 = (round(value) for value in box)
    found = []
    for y in range(y0, y1):
        for x, pixel in enumerate(picture.pixels((x0, y, x1, y + 1)), x0):
            share = share_of(pixel, colour)
            if share is not None and least <= share <= most:
                found.append((x + 0.5, y + 0.5))
    return found


def mixed(colour, share, background=BACKGROUND):
    """The colour over the background."""
    return tuple(round(b + share * (c - b)) for c, b in zip(colour, background))


def halo(colour):
    """What is drawn about a block that is selected or highlighted."""
    return mixed(colour, 0.5)
