#!/usr/bin/python3
"""What the pictures of the thesis show, by the colours and places of pixels. The truth beside them is the closed form of an
undamped oscillation: y = (v/w) sin(w t) with w = sqrt(k/m)."""
import math

from harness import App, check, check_equal, main, mass, scene, spring, support, wait
from harness import colours
from harness.scenes import connector

LINE = (-0.15, 1.0), (0.15, 2.0)  # where the middle of the connector is, and nothing else: its name stands beside it
COLOURS = {"compressed": colours.COMPRESSED, "at rest": colours.CONNECTOR, "stretched": colours.STRETCHED}


def hanging(kind="spring", speed=2, **more):
    return scene(support("Wall", 0, 3), mass("Ball", 0, 0, velocity=[0, speed]),
                 connector(kind, "Link", "Wall", "Ball", **more))


def seen(app):
    """Which state the colour of the spring tells."""
    picture, area = app.picture(), app.area(*LINE[0], *LINE[1])
    counts = {state: colours.count(picture, area, colour, least=0.7) for state, colour in COLOURS.items()}
    state = max(counts, key=counts.get)
    others = sum(count for other, count in counts.items() if other != state)
    return state if counts[state] > 30 and others < counts[state] / 10 else None


def test_spring_in_set_up(display):
    for state, length in (("compressed", 4), ("at rest", 3), ("stretched", 2)):
        with App(display, hanging(rest_length=length)) as app:
            app.show_width()
            wait(lambda: seen(app) == state, f"the spring to look {state}")


def test_spring_follows_a_drag_in_set_up(display):
    with App(display, hanging(rest_length=3, speed=0)) as app:
        app.show_width()
        app.drag((0.3, 0.3), (0.3, 0.7), release=False)
        wait(lambda: seen(app) == "compressed", "the spring to look compressed")
        app.xdotool("mousemove", *app.at(0.3, -0.7))
        wait(lambda: seen(app) == "stretched", "the spring to look stretched")
        app.xdotool("mousemove", *app.at(0.3, 0.3))
        wait(lambda: seen(app) == "at rest", "the spring to look at rest")
        app.release()


def test_spring_while_running_and_paused(display):
    with App(display, hanging(rest_length=3, stiffness=25)) as app:
        app.show_width()
        app.press("space")
        wait(app.is_playing, "the run")
        wait(lambda: seen(app) == "compressed", "a compressed spring")
        wait(lambda: seen(app) == "stretched", "a stretched spring")
        check(app.is_playing(), "it ran all the while")
        app.press("space")
        wait(lambda: not app.is_playing(), "the pause")
        for share in (0.2, 0.6, 0.9):
            app.seek(share)
            height = math.sin(5 * app.time())
            if abs(height) > 0.1:
                wait(lambda: seen(app) == ("compressed" if height > 0 else "stretched"), f"the colour of {height:.2f}")


def ink(display, kind, attached):
    """Pixels of the middle of the connector: (grey, black)."""
    ends = ["Wall", "Ball"] if attached else [(0, 3), (0, 0)]
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), connector(kind, "Link", *ends))) as app:
        app.show_width()
        app.wait_fill(colours.BODY, (-0.4, -0.4), (0.4, 0.4), least=500)
        area = app.area(*LINE[0], *LINE[1])
        picture = app.picture()
        grey = colours.count(picture, area, colours.DETACHED, least=0.75, most=1.1)
        black = colours.count(picture, area, colours.CONNECTOR, least=0.75)
        solid = colours.count(picture, area, colours.CONNECTOR, least=0.3)
    return grey, black, solid


def detached_is_grey_and_dashed(display, kind):
    grey, black, dashed = ink(display, kind, attached=False)
    _, black_attached, solid = ink(display, kind, attached=True)
    check(black == 0 and grey > 20, f"a detached {kind} is grey: {grey} grey, {black} black pixels")
    check(black_attached > 20, f"an attached {kind} is black: {black_attached} pixels")
    check(dashed < 0.85 * solid, f"a detached {kind} is dashed: {dashed} pixels, where a solid one has {solid}")


def test_detached_spring(display):
    detached_is_grey_and_dashed(display, "spring")


def test_detached_damper(display):
    detached_is_grey_and_dashed(display, "damper")


def test_detached_rod(display):
    detached_is_grey_and_dashed(display, "rod")


def test_connected_ends_are_red_crosses(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 0), connector("rod", "Link", "Wall", (2, 1)))) as app:
        app.show_width()
        app.wait_lines(colours.COMPRESSED, (-0.15, 2.85), (0.15, 3.15), least=5)
        check_equal(app.line_count(colours.COMPRESSED, (1.85, 0.85), (2.15, 1.15)), 0, "red pixels at the loose end")


def motor(angle):
    return scene(mass("Ball", 0, 0, mass=1000), connector("motor", "Motor", "Ball", angle=angle, frequency=2 * math.pi))


def arrow(app):
    """Where the arrow's pixels lie about, beyond the mass."""
    return app.middle_of_colour(colours.FORCE, (-2, -2), (2, 2))


def test_motor_is_an_orange_arrow_along_its_force(display):
    for angle, way in ((0, (1, 0)), (math.pi / 2, (0, 1)), (math.pi, (-1, 0))):
        with App(display, motor(angle)) as app:
            app.show_width()
            app.wait_lines(colours.FORCE, (-2, -2), (2, 2), least=30)
            x, y = arrow(app)
            along = (x * way[0] + y * way[1]) / math.hypot(x, y)
            check(along > 0.98, f"at {angle:.2f} rad the arrow points to ({x:.2f}, {y:.2f})")


def test_motor_turns_with_its_force(display):
    with App(display, motor(0)) as app:
        app.show_width()
        for _ in range(3):
            app.click("One Sample Forward")
        for share in (0.15, 0.3, 0.55, 0.9):
            app.seek(share)
            force = math.cos(2 * math.pi * app.time())
            if abs(force) > 0.3:
                wait(lambda: arrow(app)[0] * force > 0, f"the arrow of {force:.2f} N")


def test_offset_of_the_local_origin_is_drawn(display):
    with App(display, scene(mass("Ball", 0, 0, local_origin=[0, 2]))) as app:
        app.show_width()
        wait(lambda: app.fill_count(colours.BODY, (-0.4, -0.4), (0.4, 0.4)) > 500, "the mass")
        between = app.area(-0.3, 1.0, 0.3, 2.2)
        before = app.picture().cut(between)
        app.activate("show-local-origins")
        wait(lambda: app.picture().cut(between) != before, "the local origin to be drawn")
        app.activate("show-local-origins")
        wait(lambda: app.picture().cut(between) == before, "the local origin to go")


def test_mass_is_where_mechanics_says(display):
    """Free fall as it is seen: y = 3 - g t²/2."""
    with App(display, scene(mass("Ball", 0, 3), {"type": "gravity", "name": "Gravity"}, duration=1)) as app:
        app.show_width()
        app.click("Play")
        wait(lambda: app.time() == 1, "the end of the run")
        for share in (0.3, 0.6, 0.75):
            app.seek(share)
            app.click("One Sample Forward")  # onto a sample, for the time is shown rounded
            time = app.time()
            app.click("One Sample Forward")
            wait(lambda: app.time() > time, "a step")
            y = 3 - 9.81 * app.time() ** 2 / 2
            wait(lambda: abs(app.fill_middle(colours.BODY)[1] - y) < 0.01 * 9.81 * app.time() + 2 / app.scale(),
                 f"the mass at {y:.3f} m")


if __name__ == "__main__":
    main()
