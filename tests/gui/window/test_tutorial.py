#!/usr/bin/python3
"""The spring-mass system of the tutorial, from an empty canvas, by mouse and keyboard alone: what a student does in the
first minutes. The run is compared with the closed form y = y_eq + (y0 - y_eq) cos(w t) of a spring that starts stretched
by 1 m: w = sqrt(k / m), and the weight hangs still at a stretch of m g / k."""
import csv
import math

from harness import App, check, check_close, check_equal, main, wait

MOST_ACTIONS = 12  # clicks, keys, entries with their Return, menus with the way through them
MOST_SECONDS = 120  # of a practised person, by the keystroke-level model; see harness/keystrokes.py
STIFFNESS, MASS, GRAVITY = 25.0, 1.0, 9.81  # what new blocks have
STRETCH = 1.0        # typed


def build_and_play(app):
    app.press("ctrl+n")
    app.find(None, "New Scene")
    app.press("Return")
    app.gone(None, "New Scene")
    app.find_starting("list item", "Gravity")
    support = app.place("Support")
    mass = app.place("Mass")
    app.click_block(support, keys=["ctrl"])
    spring = app.place("Spring")
    app.click_block(mass)
    app.click("Start", role="tab")
    before = app.outline_item(mass).name
    app.retype(app.find("text", f"{spring} stretched by"), "1 m")
    app.xdotool("key", "Return")
    wait(lambda: app.outline_item(mass).name != before, f"{mass} to go down by what was typed")
    app.click_block(mass, button=3)
    app.choose("Add Graph", "Y Position")
    app.click("Play")


def export(app):
    app.right_click_graph()
    app.choose("Export Values To File…")
    file = app.home / "motion.csv"
    app.save_dialog("Export Values To File", file)
    wait(file.exists, "the file")
    with open(file, newline="") as opened:
        return list(csv.reader(opened))


def test_spring_mass_from_nothing(display):
    with App(display) as app:
        build_and_play(app)
        check(app.actions_taken <= MOST_ACTIONS, f"it took {app.actions_taken} actions")
        seconds = app.effort.total(app.actions_taken)
        check(20 < seconds < MOST_SECONDS, f"a person would take {seconds:.0f} s")
        wait(lambda: app.time() > 1.5, "some of the motion")
        head, *rows = export(app)
        check_equal(head, ["Time", "Y Position"], "head of the table")
        check(len(rows) > 150, f"{len(rows)} rows")
        start, omega = float(rows[0][1]), math.sqrt(STIFFNESS / MASS)
        rest = start + STRETCH - MASS * GRAVITY / STIFFNESS
        for time, y in rows:
            expected = rest + (start - rest) * math.cos(omega * float(time))
            check_close(float(y), expected, 1e-6, f"y at {time} s")
        digits = max(len(y.lstrip("-0.").replace(".", "")) for _, y in rows)
        check(digits >= 9, f"at most {digits} digits in the table")


if __name__ == "__main__":
    main()
