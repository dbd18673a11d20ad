#!/usr/bin/python3
"""Opening, saving, and the question about what is not saved."""
import json

from harness import App, check, check_equal, main, mass, scene, spring, support, wait
from harness import scenes


def one_mass(**more):
    return scene(mass("A", 0, 0), **more)


def edit(app):
    """A change that is not saved."""
    app.place("Mass")
    wait(lambda: app.title().startswith("•"), "the mark of what is not saved")


def test_mark_of_changes(display):
    with App(display, one_mass()) as app:
        check_equal(app.title(), "test.tinker.json", "title")
        edit(app)
        app.press("ctrl+s")
        wait(lambda: app.title() == "test.tinker.json", "the mark to go")
        app.press("ctrl+z")
        wait(lambda: app.title().startswith("•"), "the mark, for the file holds the change")
        app.press("ctrl+y")
        wait(lambda: app.title() == "test.tinker.json", "the mark to go")


def question(app):
    return app.find("dialog", "Save Changes?")


def test_question_cancelled(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.press("ctrl+n")
        app.click("Cancel", inside=question(app))
        app.gone("dialog")
        check_equal(sorted(app.blocks()), ["A", "Mass 0"], "everything is still there")


def test_question_discards(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.press("ctrl+w")
        app.click("Discard", inside=question(app))
        wait(lambda: app.process.poll() is not None, "the end")
        check_equal(len(json.loads(app.file.read_text())["blocks"]), 1, "blocks in the file")


def test_question_saves(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.press("ctrl+w")
        app.click("Save", inside=question(app))
        wait(lambda: app.process.poll() is not None, "the end")
        check_equal(len(json.loads(app.file.read_text())["blocks"]), 2, "blocks in the file")


def test_close_button_asks_too(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.click("Close")
        app.click("Cancel", inside=question(app))
        app.gone("dialog")


def test_no_question_without_changes(display):
    with App(display, one_mass()) as app:
        app.press("ctrl+w")
        wait(lambda: app.process.poll() is not None, "the end")


def test_save_as_by_name(display):
    with App(display) as app:
        edit(app)
        app.press("ctrl+s")
        app.find("text", inside=app.find(None, "Save Scene"))
        app.press("ctrl+a")
        app.type(str(app.home / "named"))
        app.press("Return")
        file = app.home / "named.tinker.json"
        wait(file.exists, "the file")
        wait(lambda: app.title() == "named.tinker.json", "the title")


def test_save_as_keeps_the_first_file(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.press("ctrl+shift+s")
        app.find(None, "Save Scene")
        app.press("ctrl+a")
        app.type(str(app.home / "second.tinker.json"))
        app.press("Return")
        wait((app.home / "second.tinker.json").exists, "the file")
        check_equal(len(json.loads(app.file.read_text())["blocks"]), 1, "blocks in the first file")


def test_file_that_is_no_scene(display):
    home = display.new_home()
    file = home / "broken.tinker.json"
    file.write_text('{"tinker": 1, "blocks": [{"type": ')
    with App(display, file, home=home) as app:
        dialog = app.find("dialog", "The File Was Not Opened")
        app.click("Close", inside=dialog)
        app.gone("dialog")
        check(app.title().startswith("Untitled"), "it goes on without a file")


def test_file_that_is_not_there(display):
    home = display.new_home()
    with App(display, home / "nowhere.tinker.json", home=home) as app:
        app.click("Close", inside=app.find("dialog", "The File Was Not Opened"))
        app.gone("dialog")


def test_file_that_is_not_local(display):
    place = "http://example.org/far.tinker.json"
    with App(display, arguments=[place]) as app:
        dialog = app.find("dialog", "The File Was Not Opened")
        app.find_text(place)
        app.find_text("Copy it")
        app.click("Close", inside=dialog)
        app.gone("dialog")


def test_folder_that_cannot_be_written(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.file.unlink()
        app.file.mkdir()  # a folder of that name: nobody can write a file there, not even root
        app.press("ctrl+s")
        app.click("Cancel", inside=app.find("dialog", "The Scene Was Not Saved"))
        app.gone("dialog")
        check(app.title().startswith("•"), "it still counts as not saved")


def test_two_files_get_two_windows(display):
    home = display.new_home()
    second = scenes.write(home, "second.tinker.json", one_mass(title="Second"))
    with App(display, scene(support("Wall", 0, 3), mass("B", 0, 0), spring("S", "Wall", "B"), title="First"), home=home,
             arguments=[str(second)]) as app:
        wait(lambda: {"First", "Second"} <= {node.name for node in app.tree.refresh() if node.role == "window"},
             "two windows")


def test_saved_files_are_remembered(display):
    with App(display, one_mass()) as app:
        edit(app)
        app.saved()
        wait(lambda: (app.home / "data" / "recently-used.xbel").exists() and
             "test.tinker.json" in (app.home / "data" / "recently-used.xbel").read_text(), "the list of recent files")


if __name__ == "__main__":
    main()
