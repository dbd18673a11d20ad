"""A display and a session bus of one's own, with the accessibility bus that comes with it.

The picture of the display is a file mapped into memory, so that looking at it costs nothing.
"""
import ctypes
import mmap
import os
import pathlib
import signal
import struct
import subprocess
import tempfile
import zlib

from .waiting import wait

WIDTH, HEIGHT = 1400, 900
PR_SET_PDEATHSIG = 1
PR_SET_CHILD_SUBREAPER = 36


def end_with_parent():
    """Between fork and exec: the process gets SIGTERM when the test ends, however it ends."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM, 0, 0, 0)


class Picture:
    """What the display shows at this moment. Pixels are read as (red, green, blue) of 0 to 255."""

    def __init__(self, file):
        with open(file, "rb") as opened, mmap.mmap(opened.fileno(), 0, access=mmap.ACCESS_READ) as data:
            head = struct.unpack(">25I", data[:100])
            start = head[0] + 12 * head[19]
            self.width, self.height, self.stride = head[4], head[5], head[12]
            self.data = data[start:start + self.stride * self.height]

    def row(self, y, x0, x1):
        """The pixels of a row from x0 up to x1, as bytes in the order blue, green, red, nothing."""
        x0, x1 = max(x0, 0), min(x1, self.width)
        if not 0 <= y < self.height or x1 <= x0:
            return b""
        return self.data[y * self.stride + 4 * x0:y * self.stride + 4 * x1]

    def pixel(self, x, y):
        blue, green, red, _ = self.row(y, x, x + 1)
        return red, green, blue

    def pixels(self, box):
        """All pixels in (x0, y0, x1, y1)."""
        x0, y0, x1, y1 = (round(value) for value in box)
        for y in range(y0, y1):
            row = self.row(y, x0, x1)
            yield from zip(row[2::4], row[1::4], row[0::4])

    def cut(self, box):
        """The raw bytes in a box, to be compared with others."""
        x0, y0, x1, y1 = (round(value) for value in box)
        return b"".join(self.row(y, x0, x1) for y in range(y0, y1))

    def write_png(self, file):
        def chunk(kind, body):
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

        lines = bytearray()
        for y in range(self.height):
            row = self.row(y, 0, self.width)
            line = bytearray(3 * self.width)
            line[0::3], line[1::3], line[2::3] = row[2::4], row[1::4], row[0::4]
            lines += b"\0" + line
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        pathlib.Path(file).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
                                       chunk(b"IDAT", zlib.compress(bytes(lines), 1)) + chunk(b"IEND", b""))


class Display:
    """Runs as long as it is open; takes with it whatever was started on it."""

    def __init__(self):
        # Whoever outlives its parent becomes a child of this process, and is found in the end.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        self.folder = tempfile.TemporaryDirectory(prefix="tinker-window-")
        self.name = "display"  # of the test that it is used for
        self.path = pathlib.Path(self.folder.name)
        self.environment = self._environment()
        reader, writer = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", self.path,
             "-nolisten", "tcp", "-noreset"],
            pass_fds=[writer], preexec_fn=end_with_parent, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as answer:
            self.environment["DISPLAY"] = ":" + answer.readline().strip()
        self.bus = subprocess.Popen(
            ["dbus-daemon", "--session", "--nofork", "--nopidfile", "--print-address=1"], env=self.environment,
            preexec_fn=end_with_parent, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.environment["DBUS_SESSION_BUS_ADDRESS"] = self.bus.stdout.readline().strip()

    def _environment(self):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith(("TINKER_", "G_", "XDG_", "LC_", "DBUS_", "WAYLAND_", "GTK_", "ADW_"))}
        environment["XDG_RUNTIME_DIR"] = str(self.path / "runtime")
        (self.path / "runtime").mkdir(mode=0o700)
        environment.update(LANG="C.UTF-8", GDK_BACKEND="x11", GSK_RENDERER="cairo",
                           GTK_A11Y="atspi", GSETTINGS_BACKEND="memory", ADW_DISABLE_PORTAL="1",
                           GTK_IM_MODULE="gtk-im-context-simple", NO_AT_BRIDGE="0")
        if "ASAN_OPTIONS" in environment:  # GLib has no frame pointers: who leaks, only slow unwinding tells
            environment["ASAN_OPTIONS"] += ":fast_unwind_on_malloc=0:malloc_context_size=12"
        return environment

    def new_home(self):
        """A folder that holds everything that a user's programs remember."""
        return pathlib.Path(tempfile.mkdtemp(prefix="home-", dir=self.path))

    def patient_home(self):
        """One whose user has messages stay for a minute: who is slow to look would miss what goes by itself."""
        home = self.new_home()
        settings = home / "config" / "tinker" / "window.ini"
        settings.parent.mkdir(parents=True)
        settings.write_text("[window]\nmessage-seconds=60\n")
        return home

    def environment_of(self, home):
        folders = {f"XDG_{name}_HOME": home / name.lower() for name in ("DATA", "CONFIG", "CACHE", "STATE")}
        for folder in folders.values():
            folder.mkdir(exist_ok=True)
        settings = folders["XDG_CONFIG_HOME"] / "gtk-4.0" / "settings.ini"
        settings.parent.mkdir(exist_ok=True)
        settings.write_text("[Settings]\ngtk-enable-animations=0\n")  # nothing slides away under the pointer
        return {**self.environment, **{name: str(folder) for name, folder in folders.items()}, "HOME": str(home)}

    def picture(self):
        return Picture(self.path / "Xvfb_screen0")

    def close(self):
        """Ends all that was started. What was started by the buses themselves ends with them."""
        for process in (self.bus, self.server):
            process.terminate()
            process.wait()
        self.bus.stdout.close()
        wait(self._is_alone, "the helpers of the buses to end")
        self.folder.cleanup()

    @staticmethod
    def _is_alone():
        try:
            while os.waitpid(-1, os.WNOHANG)[0] != 0:
                pass
            return False
        except ChildProcessError:
            return True


def children():
    """The processes that have become this one's."""
    file = pathlib.Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children")
    return {int(word) for word in file.read_text().split()}


def command_of(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace").strip()
    except OSError:
        return "?"


def kill(pid):
    os.kill(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
