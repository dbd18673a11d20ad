#!/usr/bin/python3
"""Where the energy is: a fall from rest by gravity for 1 s turns m g² t²/2 = 48.118 J of 1 kg from potential into kinetic."""
import re

from harness import App, check, main, mass, scene, wait


def test_energy_is_told(display):
    with App(display, scene(mass("Ball", 0, 0, mass=1), {"type": "gravity", "name": "Gravity"}, duration=1)) as app:
        app.activate("new-graph")
        app.click("Energy")
        app.click("Play")
        wait(lambda: app.time() == 1 and not app.is_playing(), "the end of the run")
        wait(lambda: app.look("image", "Energy").description.startswith("Kinetic 48.12 J, Potential 0 J"), "the end")
        app.seek(0.02)
        wait(lambda: re.search(r"Potential 4[78]\.\S+ J", app.look("image", "Energy").description), "the start")


def test_energy_alone_has_the_page(display):
    with App(display, scene(mass("Ball", 0, 0, mass=1), {"type": "gravity", "name": "Gravity"}, duration=1)) as app:
        app.activate("new-graph")
        _, top, _, height = app.settled(app.find("label", "No Graphs Yet"))
        app.click("Energy")
        _, chart, _, tall = app.settled(app.find("image", "Energy"))
        check(chart < top and chart + tall > top + height, f"the chart is {tall} high from {chart} on")


if __name__ == "__main__":
    main()
