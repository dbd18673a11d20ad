"""How long a practised person takes for what the test does, by the keystroke-level model (Card, Moran and Newell, "The
keystroke-level model for user performance time with interactive systems", Communications of the ACM 23, 1980)."""

KEY = 0.28       # s, an average typist
POINT = 1.1      # to a target on the screen
BUTTON = 0.1     # pressed or released
HOME = 0.4       # a hand from the mouse to the keys, or back
THINK = 1.35     # before each action

BUTTONS = {"click": 2, "mousedown": 1, "mouseup": 1}


class Effort:
    """Adds up the words of xdotool."""

    def __init__(self):
        self.seconds = 0.0
        self.at_keys = False

    def _hand(self, at_keys):
        self.seconds += HOME if at_keys != self.at_keys else 0
        self.at_keys = at_keys

    def add(self, words):
        words = [str(word) for word in words]
        for place, word in enumerate(words):
            if word == "type":
                self._hand(True)
                self.seconds += KEY * len(words[-1])
                return
            if word in ("key", "keydown"):
                self._hand(True)
                self.seconds += KEY * len(words[place + 1].split("+"))
            elif word == "mousemove":
                self._hand(False)
                self.seconds += POINT
            elif word in BUTTONS:
                self.seconds += BUTTON * BUTTONS[word]

    def total(self, actions):
        return self.seconds + THINK * actions
