#!/usr/bin/python3
"""The help: the documentation, which is shown in a window of its own and needs nothing else."""
import re

from harness import App, main, mass, scene


def follow(app, text):
    """Clicks the link that a label begins with."""
    node = app.find("label", text)
    x, y, _, height = app.settled(node)
    app.xdotool("mousemove", x + 20, y + min(height / 2, 8), "click", 1)


def test_f1_opens_the_documentation(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        app.press("F1")
        app.find("label", "Documentation")
        follow(app, "tutorials/incline.md")
        app.find("label", "A block on an incline")
        app.find("label", re.compile('"on": "Incline", "along": 2'))
        app.click("Back")
        app.find("label", "Documentation")
        app.find("label", "window.md")


def test_menu_has_help_and_keys(display):
    with App(display, scene(mass("Ball", 0, 0))) as app:
        app.click(app.find(None, "Main Menu"))
        app.choose("Help")
        app.find("label", "Documentation")
        app.click("Keyboard Shortcuts")
        app.find("label", "Play or pause")


if __name__ == "__main__":
    main()
