#!/usr/bin/python3
"""Accuracy at a glance, and the page that measures it."""
import math
import re

from harness import App, check, check_equal, main, mass, scene, spring, support, wait


def oscillator(**run):
    content = scene(support("Wall", 0, 3), mass("A", 0, 0), spring("S", "Wall", "A", rest_length=2), duration=1)
    content["run"].update(run)
    return content


def test_status_line_names_method_and_step(display):
    with App(display, oscillator(method="rk4", step=0.01)) as app:
        app.find("label", re.compile("step 0.01 s"))
        app.click("Play")
        app.find("label", re.compile("^energy"))


def test_measuring_ends_with_a_chart(display):
    with App(display, oscillator()) as app:
        app.click("Accuracy", role="tab")
        app.click("Measure")
        app.find("image", re.compile("^Chart of the error"))
        app.find("button", "Measure Again")


def test_measure_is_in_sight_in_a_small_window(display):
    with App(display, oscillator()) as app:
        widest = max(app.windows(), key=lambda window: window[1][2])
        app.xdotool("windowsize", widest[0], 800, 500)
        wait(lambda: app.canvas_box()[2] < 450, "the canvas to be small")
        app.click("Accuracy", role="tab")
        _, top, _, height = app.settled(app.find("button", "Measure"))
        check(top + height <= app.settled(app.find("slider", "Time line"))[1], "it is below what is seen of the page")


def test_method_is_offered_where_one_helps_alone(display):
    carts = scene(mass("A", -2, 0, velocity=[3, 0]), mass("B", 2, 0), duration=2)
    with App(display, carts) as app:
        app.click("Play")
        app.find("button", re.compile("^A and B overlap at "))
        check(app.look("button", "Compare Methods") is None, "no method keeps bodies apart that pass through each other")
    with App(display, oscillator(method="semi-implicit-euler", step=0.15)) as app:
        app.click("Play")
        app.find("button", re.compile("energy"))
        app.find("button", "Choose Automatically")


def test_samples_that_miss_a_swing_are_made_more(display):
    """A swing of a second, recorded once a second, would be drawn as rest."""
    swing = scene(support("Wall", 0, 0, solid=False), mass("M", 2, 0, mass=1),
                  spring("S", "Wall", "M", stiffness=4 * math.pi**2, rest_length=1))
    swing["run"]["interval"] = 1
    with App(display, swing) as app:
        app.click("Play")
        app.find_text("M swings faster than samples 1 s apart can show")
        app.click("Record More Often")
        wait(lambda: app.time() == 0, "the run to begin anew")
        check(app.saved()["run"]["interval"] <= 0.125, "eight samples to a period")
        app.xdotool("key", "ctrl+z")
        check_equal(app.saved()["run"]["interval"], 1, "the interval, as it was")


def test_shapes_that_overlap_are_told_of_before_the_run(display):
    box = {"type": "box", "name": "Box", "position": [0, 0.99995]}
    with App(display, scene(support("Floor", 0, 0.4), box)) as app:
        app.find_text("Box and Floor overlap at the start")


if __name__ == "__main__":
    main()
