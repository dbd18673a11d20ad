#!/usr/bin/python3
"""Starting, quitting, and what there is to see first."""
from harness import App, check, check_equal, main, mass, scene, spring, support


def test_empty(display):
    with App(display) as app:
        check(app.title().startswith("Untitled"), f"the title is {app.title()}")
        for name in ("Mass", "Support", "Spring", "Damper", "Rod", "Motor", "Gravity"):
            app.find("button", name)


def test_file(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 1), spring("S", "Wall", "Ball"), title="Three")) as app:
        check_equal(app.title(), "Three", "title")
        check_equal(app.saved()["title"], "Three", "saved title")


if __name__ == "__main__":
    main()
