#!/usr/bin/python3
"""The spring-mass system of the tutorial, from an empty canvas, by mouse and keyboard alone: what a student does in the
first minutes. The run is compared with the closed form y = y_eq + (y0 - y_eq) cos(w t) of a spring that starts stretched
by 1 m: w = sqrt(k / m), and the weight hangs still at a stretch of m g / k."""
import csv
import math
import re

from harness import App, check, check_close, check_equal, main, wait
from harness.tap import say

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


def largest(app):
    """The greatest compression (m), read off the statistics of the graph; they are closed again."""
    x, y, _, _ = app.settled(app.find(None, re.compile("^Graph of Bumper 0: Compression")))
    app._click_at(x + 40, y + 9)
    app.actions_taken += 1
    app.press("s")
    text = wait(lambda: app.look("label", re.compile("Greatest = ")), "the statistics").name
    app.click("Close", inside=app.find(None, "Statistics"))
    return float(re.search(r"Greatest = (\S+) m", text).group(1))


def length_of_bumper(app):
    """In metres; while its end is dragged, where that is by now."""
    return float(app.read("Bumper", "Length").split()[0])


def compression(mu, way):
    """Of a block of 2 kg that slides so far (m) down 30 degrees into 400 N/m: k d^2 / 2 = F (way + d), F = m g (sin - mu cos)."""
    push = 2 * GRAVITY * (0.5 - mu * math.sqrt(0.75))
    return (push + math.sqrt(push ** 2 + 2 * 400 * push * way)) / 400


def test_block_into_a_spring(display):
    """2 kg slide 3 m down an incline of 30 degrees with friction of 0.2 into a spring of 400 N/m: how far is it compressed, and
    how does that change with the friction? Without leaving the window: by graph, then by a slider beside the run that is kept."""
    def on_incline(along, off):
        return along * math.cos(math.pi / 6) + off / 2, 1.4 - along / 2 + off * math.cos(math.pi / 6)

    with App(display) as app:
        app.press("ctrl+n")
        app.find(None, "New Scene")
        app.press("Return")
        app.gone(None, "New Scene")
        app.actions_taken = 0
        app.place("Support")
        for group, title, text in (("Friction", "Dynamic coefficient", "0.2"), ("Friction", "Static coefficient", "0.2"),
                                   ("Properties", "Orientation", "-30 deg"), ("Size", "Width", "8 m")):
            app.enter(group, title, text)
        app.drag_pixels(app.middle(app.palette_button("Mass")), app.at(*on_incline(-2.5, 0.7)))
        app.find_starting("list item", "Mass 0")
        app.enter("Properties", "Mass", "2 kg")
        app.click(app.find_starting("list item", "Support 0"))
        app._click_at(*app.middle(app.find_starting("list item", "Mass 0")), keys=("ctrl",))
        app.actions_taken += 1
        app.place("Bumper")
        app.drag_pixels(app.at(0, 1.4), app.at(*on_incline(1.5, 0)), app.at(*on_incline(3, 0)))
        length = wait(lambda: (read := length_of_bumper(app)) > 5 and read, "the length where the drag ends, 3 m down the incline")
        app.enter("Bumper", "K", "400")
        app.enter("Bumper", "Length", f"{length:.5f}-3")
        app.click(app.find_starting("list item", "Bumper 0"), button=3)
        app.choose("Add Graph", "Compression")
        app.click("Play")
        wait(lambda: app.time() > 2 and not app.is_playing(), "the end of the run, with all of the curve")
        check_close(largest(app), compression(0.2, 3), 1e-4, "largest compression (m)")
        found_by = app.actions_taken
        app.press("ctrl+k")
        app.click(app.find_starting("list item", "Support 0"))
        app.bring_into_view(app.field("Friction", "Dynamic coefficient"))
        app.click(app.field("Friction", "Dynamic coefficient"), button=3)
        app.choose("Add Control")
        slider = app.find("slider", re.compile("^Support 0"))
        x, y, width, height = app.settled(slider)
        share = slider.value() / slider.most()
        app.drag_pixels((x + 8 + share * (width - 16), y + height / 2), (x + 0.2 * width, y + height / 2))
        wait(lambda: slider.value() < 0.12, "less friction")
        actions = app.actions_taken + 3

        def shows_new_run():
            app.actions_taken = actions
            return abs(largest(app) - compression(slider.value(), 3)) <= 1e-4

        wait(shows_new_run, "the largest compression with less friction")
        say(f"{found_by} actions to the compression, {app.actions_taken} with another friction")
        check(found_by <= 20 and app.actions_taken <= 30, f"it took {found_by} and {app.actions_taken} actions")


if __name__ == "__main__":
    main()
