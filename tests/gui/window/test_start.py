#!/usr/bin/python3
"""Starting, quitting, and what there is to see first."""
from harness import App, check, check_equal, main, mass, scene, spring, support, wait

CONTROLS = ("button", "check box", "text", "entry", "combo box", "slider", "list item", "tab")
INNER = "GtkToggleButton"  # the button in a list to choose from, which has the name


def test_empty(display):
    with App(display) as app:
        check(app.title().startswith("Untitled"), f"the title is {app.title()}")
        for name in ("Mass", "Support", "Spring", "Damper", "Rod", "Motor", "Gravity"):
            app.find("button", name)


def test_file(display):
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 1), spring("S", "Wall", "Ball"), title="Three")) as app:
        check_equal(app.title(), "Three", "title")
        check_equal(app.saved()["title"], "Three", "saved title")


def unnamed(app):
    """What a screen reader would have no word for."""
    shown = [node for node in app.tree.refresh(True) if node.role in CONTROLS and node.is_shown()]
    check(len(shown) > 40, f"{len(shown)} controls")
    return [node for node in shown if not node.name.strip() or node.name.startswith("Gtk") and
            not (node.name == INNER and node.parent().role == "combo box")]


def test_every_control_has_a_name(display):
    instruments = {"controls": [{"block": "S", "property": "stiffness", "from": 0, "to": 50, "kind": "slider", "place": [-4, 2]}],
                   "meters": [{"block": "Ball", "quantity": "y", "kind": "bar", "place": [2, 2]}],
                   "graphs": [{"block": "Ball", "quantity": "y"}]}
    with App(display, scene(support("Wall", 0, 3), mass("Ball", 0, 1), spring("S", "Wall", "Ball"), **instruments)) as app:
        app.click_block("Ball")
        for tab in ("Properties", "Scene", "Start", "Equations", "Graphs", "Accuracy"):
            app.click(tab, role="tab")
            wait(lambda: not unnamed(app), f"names of all controls with {tab}")


def test_start_of_what_has_none(display):
    """A force has no start of its own: its page says so, and is not empty."""
    push = {"type": "motor", "name": "Push", "ends": ["Ball"]}
    with App(display, scene(mass("Ball", 0, 1), push)) as app:
        app.click("Start", role="tab")
        app.find_text("Select one body or connector to say how it starts.")
        app.click(app.find_starting("list item", "Push"))
        app.find_text("Push starts as its properties say.")


if __name__ == "__main__":
    main()
