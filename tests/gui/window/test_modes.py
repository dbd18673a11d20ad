#!/usr/bin/python3
"""Natural frequencies and modes: a bob of 1 kg on a spring of 25 N/m that is 2 m long at rest without it. It swings up and down
with sqrt(k/m) / 2 pi = 0.7958 Hz and sideways, as a pendulum, with sqrt(g/L) / 2 pi = 0.3223 Hz of the stretched length."""
import os
import re
import time

from harness import App, check, main, mass, scene, spring, support, wait

SIDEWAYS = "Mode 1, sideways: ω₀ = 2.025 rad/s, f = 0.3223 Hz, T = 3.103 s"
UPRIGHT = "Mode 2, up and down: ω₀ = 5 rad/s, f = 0.7958 Hz, T = 1.257 s"


def hanging():
    return scene({"type": "gravity", "name": "Gravity"}, support("Wall", 0, 3, solid=False),
                 mass("Bob", 0, 0.6076), spring("Spring", "Wall", "Bob", stiffness=25, rest_length=2))


def open_modes(app):
    app.show_width()
    app.click("Equations", role="tab")
    app.click("Natural Frequencies and Modes")
    return app.find("list item", SIDEWAYS)


def test_frequencies_and_shapes(display):
    """Of a desktop that does not want animations, what a mode does is shown at its greatest."""
    with App(display, hanging()) as app:
        item = open_modes(app)
        app.find("list item", UPRIGHT)
        areas = app.area(0.46, 0.2, 0.6, 1), app.area(-0.3, 1.05, -0.15, 1.2)  # beside the bob, and above it

        def look():
            picture = app.picture()
            return [picture.cut(area) for area in areas]

        beside, above = look()
        app.click(item, role="list item")
        wait(lambda: look()[0] != beside and look()[1] == above, "the bob at the right")
        app.press("Down")
        wait(lambda: look()[0] == beside and look()[1] != above, "the bob above")
        app.click("Natural Frequencies and Modes", role="label")  # the button is as large as all of it
        wait(lambda: look() == [beside, above], "the scene as it is")


def test_a_mode_is_switched_off(display):
    """By a second click, Escape, a click on the canvas, and by playing, which shows the motion alone."""
    with App(display, hanging()) as app:
        item = open_modes(app)
        area = app.area(0.46, 0.2, 0.6, 1)  # beside the bob

        def look():
            return app.picture().cut(area)

        plain = look()
        for end in (lambda: app.click(item, role="list item"), lambda: app.press("Escape"), lambda: app.click_world(1.5, 2)):
            app.click(item, role="list item")
            wait(lambda: look() != plain, "the bob at the right")
            time.sleep(0.6)  # no double click
            end()
            wait(lambda: look() == plain, "the scene as it is")
            check(not item.refreshed().has("selected"), "the mode is no longer selected")
        app.click(item, role="list item")
        wait(lambda: look() != plain, "the bob at the right")
        app.click("Play")
        wait(lambda: not item.refreshed().has("selected") and look() == plain, "the motion, which is upright, alone")
        app.click(item, role="list item")
        wait(lambda: not app.is_playing() and look() != plain, "the mode, for which the run stands still")


def test_what_friction_holds_has_no_modes(display):
    content = scene({"type": "gravity", "name": "Gravity"},
                    support("Floor", 0, -0.5, width=10, height=0.6, static_friction=0.5, dynamic_friction=0.4),
                    mass("Bob", 0, 0.2, mass=2, width=0.8, height=0.8))
    with App(display, content) as app:
        app.click("Equations", role="tab")
        app.click("Natural Frequencies and Modes")
        text = app.find_text("There is nothing to swing: what touches leaves none of the scene's 2 degrees of freedom")
        check("Bob: held on Floor by friction" in text.name, "what holds it")


def test_numbers_are_those_of_the_matrix(display):
    """Two masses of 1 kg on 3, 2 and 3 N/m: x1 = x2 with sqrt 3 rad/s, x1 = -x2 with sqrt 7 rad/s; up and down nothing holds them."""
    content = scene(support("Left", -3, 0, solid=False), mass("A", -1, 0), mass("B", 1, 0), support("Right", 3, 0, solid=False),
                    spring("S1", "Left", "A", stiffness=3), spring("S2", "A", "B", stiffness=2),
                    spring("S3", "B", "Right", stiffness=3))
    with App(display, content) as app:
        app.click("Equations", role="tab")
        app.click("Natural Frequencies and Modes")
        app.find("list item", re.compile(r"^Mode 1, sideways in step: ω₀ = 1\.732 .*\nA : B = 1 : 1$"))
        app.find("list item", re.compile(r"^Mode 2, sideways against each other: ω₀ = 2\.646 .*\nA : B = 1 : −1$"))
        app.find("list item", re.compile("^Mode, up and down.*0 Hz"))


def test_what_drives_it_near_resonance(display):
    """Up and down with 5.2 rad/s, where the bob answers most at 5; sideways it swings at 2.025, which that does not drive."""
    content = hanging()
    content["blocks"].append({"type": "motor", "name": "Push", "ends": ["Bob"], "angle": "90 deg", "amplitude": 1,
                              "waveform": "sine", "frequency": 5.2})
    with App(display, content) as app:
        open_modes(app)
        app.find_text("Push drives with 5.2 rad/s (0.8276 Hz), near resonance at 5 rad/s (0.7958 Hz)")
        app.find("image", "Response of Bob.y to Push")
        keep = os.environ.get("TINKER_PICTURES")
        if keep:
            app.picture().write_png(f"{keep}/response.png")
    content["blocks"][-1]["frequency"] = 2.03  # near the other one
    with App(display, content) as app:
        open_modes(app)
        app.find("image", "Response of Bob.y to Push")
        check(app.look("label", "Push drives with 2.03 rad/s") is None, "no word of the mode that it does not drive")


def test_frequency_says_that_it_is_near_resonance(display):
    """The same beside the frequency itself, of the motor and of a motion that the wall shows; it goes with what is typed."""
    content = hanging()
    content["blocks"].insert(0, {"type": "motor", "name": "Push", "ends": ["Bob"], "angle": "90 deg", "amplitude": 1,
                              "waveform": "sine", "frequency": 5.2})
    content["blocks"].append({"type": "support-motion", "name": "Shake", "ends": ["Wall"], "angle": "90 deg", "amplitude": 0.1,
                              "waveform": "sine", "frequency": 1})
    hint = "Near resonance at 5 rad/s (0.7958 Hz)"
    with App(display, content) as app:
        app.show_width()
        app.click(re.compile("^Push, "), role="list item")
        app.find("alert", hint)
        keep = os.environ.get("TINKER_PICTURES")
        if keep:
            app.picture().write_png(f"{keep}/near.png")
        app.enter("Force", "Frequency", "8")
        app.gone("alert", hint)
        app.click(re.compile("^Wall, "), role="list item")
        app.enter("Motion", "Frequency", "4.8")
        app.find("alert", hint)
        app.enter("Motion", "Frequency", "2.03")
        app.gone("alert", hint)


def test_an_edit_makes_new_ones(display):
    """Four times as heavy, half the frequency."""
    with App(display, hanging()) as app:
        open_modes(app)
        app.find("list item", UPRIGHT)
        app.click_world(0, 0.6)
        app.click("Properties", role="tab")
        app.enter("Properties", "Mass", "4 kg")
        app.click("Equations", role="tab")
        app.find("list item", re.compile("^Mode 2, up and down: .*f = 0.3979 Hz"))


if __name__ == "__main__":
    main()
