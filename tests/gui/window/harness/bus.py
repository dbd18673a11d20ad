"""Calls over D-Bus, by libdbus' own binding: that of GLib takes ten times as long to hand over a window's thousands of values."""
import dbus
import dbus.bus

from .waiting import Gone

TIMEOUT = 20  # s


class Bus:
    """A connection of its own, which ends with the process."""

    def __init__(self, address):
        self.connection = dbus.bus.BusConnection(address)
        self.connection.set_exit_on_disconnect(False)

    def call(self, name, path, interface, method, signature="", *values):
        """What the method answers: a value, or a tuple of several."""
        try:
            return self.connection.call_blocking(name, path, interface, method, signature, values, TIMEOUT)
        except dbus.DBusException as error:
            raise Gone(f"{interface}.{method}: {error.get_dbus_message()}") from None
