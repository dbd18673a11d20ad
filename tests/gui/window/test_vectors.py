#!/usr/bin/python3
"""Velocity, acceleration, net force and trails on the canvas, of bodies that fall freely: v = g t, a = g, g t^2 / 2 of way."""
import os

from harness import App, check, check_close, check_equal, colours, main, mass, scene, wait

MOTION = (0x0b, 0x8a, 0x8a)
ACCELERATION = (0xd5, 0x5e, 0x00)
NET = (0x00, 0x00, 0x00)
GRAVITY = {"type": "gravity", "name": "Gravity", "acceleration": 2}


def falling(x=0, name="Ball"):
    return mass(name, x, 4, width=0, height=0)


def go_to(app, time):
    app.activate("go-to", float(time))
    wait(lambda: abs(app.time() - time) < 1e-3, f"the time {time} s")


def upright(app, colour, x, top, bottom):
    """How long the arrow of this colour is at x (px), from its upper end to the first gap: its label is below it."""
    area = app.area(x - 0.04, bottom, x + 0.04, top)
    rows = sorted({place[1] for place in colours.places(app.picture(), area, colour)})
    end = next((i for i, (here, there) in enumerate(zip(rows, rows[1:])) if there - here > 4), len(rows) - 1)
    return rows[end] - rows[0] + 1 if rows else 0


def settle(app, colour, x, top, bottom, least):
    wait(lambda: upright(app, colour, x, top, bottom) > least, "an arrow")
    length = upright(app, colour, x, top, bottom)
    wait(lambda: upright(app, colour, x, top, bottom) == length, "an arrow that stays")
    return length


def keep(app, name):
    """For whoever wants to see it."""
    folder = os.environ.get("TINKER_PICTURES")
    if folder:
        app.picture().write_png(f"{folder}/{name}.png")


def test_velocity_has_one_scale(display):
    """Half the time, half the arrow; it starts where the ball is, at 4 - t^2."""
    with App(display, scene(falling(), GRAVITY, duration=2)) as app:
        app.show_width()
        app.activate("show-velocities")
        go_to(app, 2)
        whole = settle(app, MOTION, 0, 0, -2, 20)
        go_to(app, 1)
        half = settle(app, MOTION, 0, 3, 1, 10)
        check_close(half, whole / 2, 3, "length of the arrow at half the time")
        keep(app, "velocity")


def test_acceleration_stays_and_net_force_goes_with_the_mass(display):
    light, heavy = falling(-2, "Light"), {**falling(2, "Heavy"), "mass": 3}
    with App(display, scene(light, heavy, GRAVITY, duration=2)) as app:
        app.show_width()
        app.activate("show-accelerations")
        before = settle(app, ACCELERATION, -2, 4, 1, 20)
        check_close(settle(app, ACCELERATION, 2, 4, 1, 20), before, 2, "length of the other's arrow")
        go_to(app, 1)
        check_close(settle(app, ACCELERATION, -2, 3, 0, 20), before, 2, "length of the arrow later")
        app.activate("show-accelerations")
        app.activate("show-labels")  # they are as black as a net force
        app.activate("show-net-forces")
        third = settle(app, NET, -2, 3, 0, 5)
        check_close(settle(app, NET, 2, 3, 0, 3 * third - 8), 3 * third, 5, "length of the arrow of three times the mass")
        keep(app, "net-force")
        app.click_world(2, 3)
        wait(lambda: upright(app, NET, -2, 3, 0) == 0, "the other's arrow to go")


def test_trail_has_marks_at_equal_times(display):
    """Of 2 s there are marks every 0.2 s, at 4 - t^2, and none where the ball is not yet."""
    def marks(app, bottom):
        x0, y0, x1, y1 = app.area(-0.02, bottom, 0.02, 4.2)
        wide = [sum(colours.share_of(pixel, MOTION) is not None and colours.share_of(pixel, MOTION) > 0.6
                    for pixel in app.picture().pixels((x0 - 3, y, x1 + 3, y + 1))) for y in range(int(y0), int(y1))]
        return sum(1 for before, after in zip(wide, wide[1:]) if before < 4 <= after)

    with App(display, scene(falling(), GRAVITY, duration=2)) as app:
        app.show_width()
        app.activate("show-trails")
        go_to(app, 2)
        wait(lambda: upright(app, MOTION, 0, 4.1, -0.1) > 100, "the path")
        keep(app, "trail")
        late = marks(app, 1)  # below it the ball is after 1.73 s
        check(6 <= late <= 9, f"{late} marks above 1 m")  # the first ones touch each other
        go_to(app, 1)
        wait(lambda: upright(app, MOTION, 0, 2.8, -0.1) == 0, "the path behind the ball to go")
        app.activate("show-trails")
        wait(lambda: upright(app, MOTION, 0, 4.1, 3.2) == 0, "the path to go")


if __name__ == "__main__":
    main()
