"""A real window on a display that nobody sees, worked by mouse and keyboard, read by what assistive programs read.

Only what Debian has: python3-dbus, Xvfb, xdotool, dbus-daemon and the accessibility bus (at-spi2-core).
"""
from . import colours
from .app import App
from .scenes import mass, scene, spring, support
from .tap import Failure, check, check_close, check_equal, main
from .waiting import wait

__all__ = ["App", "Failure", "check", "check_close", "check_equal", "colours", "main", "mass", "scene", "spring", "support", "wait"]
