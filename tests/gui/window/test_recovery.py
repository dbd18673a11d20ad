#!/usr/bin/python3
"""After kill -9: what was not saved is offered at the next start."""
import json

from harness import App, check, check_equal, main, mass, scene, wait

OFTEN = {"TINKER_AUTOSAVE_SECONDS": "1"}


def crash(display, content):
    """Adds a mass, waits for the copy, and kills the program. Answers (home, file)."""
    app = App(display, content, environment=OFTEN)
    with app:
        app.place("Mass")
        wait(lambda: app.title().startswith("•"), "the change")
        copies = app.home
        wait(lambda: any("Mass 0" in file.read_text() for file in copies.rglob("*.tinker.json") if file != app.file),
             "the copy")
        app.kill()
    return app.home, app.file


def test_recovers_what_was_not_saved(display):
    home, file = crash(display, scene(mass("A", 0, 0)))
    check_equal(len(json.loads(file.read_text())["blocks"]), 1, "blocks in the file after the crash")
    with App(display, home=home, environment=OFTEN) as app:
        dialog = app.find("dialog", "Recover Unsaved Changes?")
        app.click("Recover", inside=dialog)
        app.gone("dialog")
        wait(lambda: app.title() == "• test.tinker.json", "the scene under its name, not saved")
        app.file = file
        check_equal(sorted(app.blocks()), ["A", "Mass 0"], "blocks")
    with App(display, home=home) as app:
        check(app.look("dialog") is None, "nothing is offered again")


def test_recovers_a_scene_without_a_file(display):
    home, _ = crash(display, None)
    with App(display, home=home, environment=OFTEN) as app:
        app.click("Recover", inside=app.find("dialog", "Recover Unsaved Changes?"))
        app.find_starting("list item", "Mass 0")
        check(app.title().startswith("•"), "it counts as not saved")


def test_discarded_is_not_offered_again(display):
    home, _ = crash(display, scene(mass("A", 0, 0)))
    with App(display, home=home) as app:
        app.click("Discard", inside=app.find("dialog", "Recover Unsaved Changes?"))
        app.gone("dialog")
    with App(display, home=home) as app:
        app.find("button", "Mass")
        check(app.look("dialog") is None, "nothing is offered")


def test_later_offers_again(display):
    home, _ = crash(display, scene(mass("A", 0, 0)))
    with App(display, home=home) as app:
        app.click("Later", inside=app.find("dialog", "Recover Unsaved Changes?"))
        app.gone("dialog")
    with App(display, home=home) as app:
        app.click("Discard", inside=app.find("dialog", "Recover Unsaved Changes?"))


def test_nothing_to_offer_after_a_proper_end(display):
    with App(display, scene(mass("A", 0, 0)), environment=OFTEN) as app:
        app.place("Mass")
        wait(lambda: app.title().startswith("•"), "the change")
        home = app.home
    with App(display, home=home) as app:
        app.find("button", "Mass")
        check(app.look("dialog") is None, "nothing is offered")


if __name__ == "__main__":
    main()
