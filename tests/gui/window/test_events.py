#!/usr/bin/python3
"""What happens in a run is told, and marked on the time line. The truth is uniform motion: a block that slides without
friction from the middle of a top 4 m long at 2 m/s is over its end at 1 s."""
import os
import re

from harness import App, check, check_close, check_equal, main, mass, scene, support, wait

GRAVITY = {"type": "gravity", "name": "Gravity"}
LEAVES = "Block leaves the end of Table"


def sliding(**more):
    table = support("Table", 0, 0, width=4, static_friction=0, dynamic_friction=0)
    block = {"type": "mass", "name": "Block", "on": "Table", "velocity": [2, 0], "width": 0.4, "height": 0.4}
    return scene(table, block, GRAVITY, **{"duration": 2, **more})


def told(app):
    return app.look("label", re.compile(re.escape(LEAVES)))


def test_last_event_is_told(display):
    with App(display, sliding()) as app:
        app.click("Play")
        wait(lambda: app.time() == 2 and not app.is_playing(), "the end")
        check_equal(app.find_text(LEAVES).name, f"1 s: {LEAVES}", "what is told at the end")
        app.seek(0.25)
        wait(lambda: told(app) is None, "nothing to be told of before it happens")
        app.seek(0.75)
        wait(lambda: told(app), "it to be told of again")
        app.click("Reset to the Start")
        wait(lambda: told(app) is None, "nothing to be told of before a run")


def test_box_leaves_only_with_its_last_corner(display):
    """A box 0.6 m long slides at 1 m/s to the end of its top, 1 m away: a corner passes that at 0.7 s."""
    table = support("Table", 0, -0.2, width=2, static_friction=0, dynamic_friction=0)
    box = {"type": "box", "name": "Box", "width": 0.6, "height": 0.4, "position": [0, 0.2], "velocity": [1, 0],
           "static_friction": 0, "dynamic_friction": 0}
    with App(display, scene(table, box, GRAVITY, duration=2)) as app:
        app.click("Play")
        wait(lambda: app.time() == 2 and not app.is_playing(), "the end")
        for share, words in ((0.4, "0.7 s: Box comes to the end of Table"),
                             (0.55, "1 s: Box lifts off Table at a corner")):
            app.seek(share)
            app.find_text(words)
        app.seek(0.95)
        app.find("label", re.compile("^1.3[0-9]* s: Box lifts off Table$"))


def test_law_of_impact_that_decides_is_offered(display):
    """One ball strikes two that touch: by Newton it comes back, by blows one after the other it stops."""
    balls = [{"type": "disc", "name": f"Ball {i}", "radius": 0.5, "position": [x, 0], "restitution": 1, "solid": True}
             for i, x in enumerate((-2, 0, 1))]
    balls[0]["velocity"] = [2, 0]
    with App(display, scene(*balls, duration=1)) as app:
        app.click("Play")
        notice = app.find("button", re.compile("depends on the impact law: at 0.5 s"))
        check("impact_law" not in notice.name, f"a key of files is in “{notice.name}”")
        app.click("Choose the Law of Impact")
        law = app.field("Computation", "Law of Impact")
        wait(lambda: any(node.has("focused") and node.is_inside(law) for node in app.tree.refresh()), "the focus on it")
        app.choose_in("Computation", "Law of Impact", "One After the Other")
        check_equal(app.saved()["run"]["impact_law"], "sequential", "the law in the file")


def test_time_line_is_marked_where_something_happens(display):
    with App(display, sliding(duration=2.5)) as app:
        app.click("Play")
        wait(lambda: app.time() == 2.5 and not app.is_playing(), "the end")
        line = app.find("slider", "Time line")
        wait(lambda: line.refreshed().description == f"1 s: {LEAVES}", "the line to be described")
        app.seek(0.2)
        x, y, width, height = app.settled(line)
        app.xdotool("mousemove", 10, 10)

        def marked():
            """Where something sticks out of the trough, right of the handle (px from the line's left)."""
            first, picture = width * 0.3, app.picture()
            rows = [list(picture.pixels((x + first, row, x + width, row + 1))) for row in range(round(y) - 8, round(y))]
            return {first + place for row in rows for place, pixel in enumerate(row) if pixel != row[-1]}

        wait(marked, "a mark")
        check_close(sum(marked()) / len(marked()), 0.4 * width, 2, "place of the mark (px), at 0.4 of the duration")
        app.xdotool("mousemove", x + 0.4 * width, y + height / 2)
        app.find("label", f"1 s: {LEAVES}")
        app._click_at(x + 0.4 * width + 2, y + height / 2)
        wait(lambda: app.time() == 1, "the time of the event, not that of the pointer beside its mark")
        app.xdotool("mousemove", x + 0.4 * width + 2, y + height / 2, "mousedown", 1)
        for part in (0.42, 0.5, 0.6, 0.7):
            app.xdotool("mousemove", x + part * width, y + height / 2)
        wait(lambda: app.time() > 1.6, "the line to be dragged on from the mark")
        app.xdotool("mouseup", 1)


def test_line_without_events_says_nothing(display):
    with App(display, scene(mass("Ball", 0, 3), GRAVITY, duration=1)) as app:
        app.click("Play")
        wait(lambda: app.time() == 1 and not app.is_playing(), "the end")
        check_equal(app.find("slider", "Time line").description, "", "description of the line")


def test_extrema_of_the_curve_worked_at(display):
    """x = cos(w t) with w = 2 pi / 1 s: least at 0.5 and 1.5 s, greatest at 1 s; the samples miss them by up to 0.01 s."""
    ball = mass("Ball", 1, 0, mass=1)
    content = scene(support("Wall", -2, 0, solid=False), ball,
                    {"type": "spring", "name": "Spring", "ends": ["Wall", "Ball"], "stiffness": 39.47841760435743,
                     "rest_length": 2}, graphs=[{"block": "Ball", "quantity": "x"}], duration=1.8, interval=0.03)
    with App(display, content) as app:
        app.click("Play")
        wait(lambda: app.time() == 1.8 and not app.is_playing(), "the end")
        line = app.find("slider", "Time line")
        check_equal(line.description, "", "description before there is a curve that is worked at")
        app.click(app.find(None, re.compile("^Graph of ")))
        wait(lambda: line.refreshed().description.count("\n") == 2, "three marks")
        told = line.description.split("\n")
        for text, time, kind in zip(told, (0.5, 1, 1.5), ("minimum", "maximum", "minimum")):
            check_close(float(text.split(" s: ")[0]), time, 1e-3, f"time of {text}")
            check(text.endswith(f"({kind})"), f"{text}: {kind}")
        x, y, width, height = app.settled(line)
        keep = os.environ.get("TINKER_PICTURES")
        if keep:
            app.picture().write_png(f"{keep}/extrema.png")
        app._click_at(x + 1 / 1.8 * width + 2, y + height / 2)
        wait(lambda: app.time() == 1, "the time of the maximum, not that of the pointer beside its mark")


def test_more_extrema_than_can_be_told_apart_are_not_marked(display):
    """cos(w t) with w = 2 pi / 0.1 s has 59 maxima and 60 minima in 5.98 s, and 20 more a second later. Another curve of one
    minimum is looked at first, whose mark goes."""
    def swing(name, x, stiffness):
        return ({"type": "support", "name": f"Wall of {name}", "position": [-3, x], "solid": False},
                mass(name, 0, x, mass=1),
                {"type": "spring", "name": f"Spring of {name}", "ends": [f"Wall of {name}", name], "stiffness": stiffness,
                 "rest_length": 2})

    for duration, told in ((5.98, "and 99 more"), (6.98, "")):
        content = scene(*swing("Fast", 0, 3947.841760435743), *swing("Slow", 2, 0.6), duration=duration,
                        graphs=[{"block": name, "quantity": "x"} for name in ("Fast", "Slow")])
        with App(display, content) as app:
            app.activate("go-to", duration)
            wait(lambda: app.time() == duration, "the end")
            line = app.find("slider", "Time line")
            app.click(app.find(None, re.compile("^Graph of Slow")))
            wait(lambda: line.refreshed().description.endswith("(minimum)"), "the mark of the slow one")
            app.click(app.find(None, re.compile("^Graph of Fast")))
            wait(lambda: line.refreshed().description.split("\n")[-1] == told, f"“{told}”")


if __name__ == "__main__":
    main()
