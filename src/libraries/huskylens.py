# huskylens.py: the AI camera HuskyLens in the words of the classroom, with the names that WebTigerPython's module has. Our
# own code; it talks to the camera as its maker describes and runs on real boards as well: put this file on the board.
#
# The picture is 320 wide and 240 high; x grows to the right and y upwards.

from math import atan2, degrees
from microbit import i2c, running_time, sleep

_ADDRESS = 0x32
_OK, _INFO, _BLOCK, _IS_PRO = 0x2E, 0x29, 0x2A, 0x3B


class Algorithm:
    """What the camera looks for."""

    FACE_RECOGNITION = 0
    OBJECT_TRACKING = 1
    OBJECT_RECOGNITION = 2
    LINE_TRACKING = 3
    COLOR_RECOGNITION = 4
    TAG_RECOGNITION = 5
    OBJECT_CLASSIFICATION = 6
    QR_RECOGNITION = 7
    BARCODE_RECOGNITION = 8


class Block:
    """A thing in a box around (x, y)."""

    def __init__(self, x, y, width, height, id):
        self.x, self.y, self.width, self.height, self.id = x, y, width, height, id

    def __str__(self):
        return "Block %d at (%d, %d), %d x %d" % (self.id, self.x, self.y, self.width, self.height)


class Arrow:
    """A line from its tail, which is near, to its head."""

    def __init__(self, x_tail, y_tail, x_head, y_head, id):
        self.x_tail, self.y_tail, self.x_head, self.y_head, self.id = x_tail, y_tail, x_head, y_head, id

    def get_direction(self):
        """Degrees clockwise: 0 up in the picture, 90 to the right."""
        return int(degrees(atan2(self.x_head - self.x_tail, self.y_head - self.y_tail)) % 360)

    def __str__(self):
        return "Arrow %d from (%d, %d) to (%d, %d)" % (self.id, self.x_tail, self.y_tail, self.x_head, self.y_head)


def _receive(timeout):
    """The next frame: its command and its data; None: nothing came in time."""
    end = running_time() + timeout
    while i2c.read(_ADDRESS, 1)[0] != 0x55:
        if running_time() > end:
            return None, b""
        sleep(1)
    head = b"\x55" + i2c.read(_ADDRESS, 4)
    rest = i2c.read(_ADDRESS, head[3] + 1)
    if head[1] != 0xAA or (sum(head) + sum(rest[:-1])) & 0xFF != rest[-1]:
        return None, b""
    return head[4], rest[:-1]


def _ask(command, data=b"", timeout=500):
    """Send a request and take the first frame of its answer."""
    frame = b"\x55\xaa\x11" + bytes([len(data), command]) + data
    i2c.write(_ADDRESS, frame + bytes([sum(frame) & 0xFF]))
    return _receive(timeout)


def _middle_distance(thing):
    if isinstance(thing, Block):
        x, y = thing.x, thing.y
    else:
        x, y = (thing.x_tail + thing.x_head) / 2, (thing.y_tail + thing.y_head) / 2
    return (x - 160) ** 2 + (y - 120) ** 2


def _centermost(things):
    return min(things, key=_middle_distance) if things else None


class Huskylens:
    """The camera. Without one on the bus: OSError."""

    def __init__(self):
        self.algorithm = None
        self.clear_texts()

    def _says_ok(self, command, data=b""):
        return _ask(command, data)[0] == _OK

    def initialize(self):
        """Whether the camera answers."""
        return self._says_ok(0x2C)

    def is_pro(self):
        command, data = _ask(_IS_PRO)
        return command == _IS_PRO and data[0] == 1

    def set_algorithm(self, algorithm):
        """Look for something else from now on; False: this camera cannot."""
        done = self._says_ok(0x2D, bytes([algorithm, 0]))
        if done:
            self.algorithm = algorithm
            sleep(50)
        return done

    def _results(self, command, data=b""):
        kind, info = _ask(command, data)
        if kind != _INFO:
            return []
        things = []
        for _ in range(info[0] + 256 * info[1]):
            kind, data = _receive(500)
            if kind is None:
                break
            a, b, c, d, id = [data[i] + 256 * data[i + 1] for i in range(0, 10, 2)]
            things.append(Block(a, 240 - b, c, d, id) if kind == _BLOCK else Arrow(a, 240 - b, c, 240 - d, id))
        return things

    def get_all(self):
        return self._results(0x20)

    def get_all_learned(self):
        return self._results(0x23)

    def get_all_with_id(self, id):
        return self._results(0x26, bytes([id & 0xFF, id >> 8]))

    def get_one(self):
        """The thing nearest to the middle of the picture, or None."""
        return _centermost(self.get_all())

    def get_one_learned(self):
        return _centermost(self.get_all_learned())

    def get_one_with_id(self, id):
        return _centermost(self.get_all_with_id(id))

    def learn(self, id, name=None):
        """What is in the middle of the picture has this id from now on."""
        done = self._says_ok(0x36, bytes([id & 0xFF, id >> 8]))
        return done and (name is None or self.attach_label(id, name))

    def forget(self):
        return self._says_ok(0x37)

    def attach_label(self, id, name):
        text = name.encode()
        return self._says_ok(0x2F, bytes([id, len(text) + 1]) + text + b"\0")

    def clear_labels(self):
        for id in range(10):
            self.attach_label(id, "")

    def add_text(self, text, x, y):
        """Write on the camera's screen."""
        data = text.encode()
        place = bytes([len(data), 0xFF if x > 255 else 0, x - 255 if x > 255 else x, 240 - y])
        return self._says_ok(0x34, place + data)

    def clear_texts(self):
        return self._says_ok(0x35)

    def save_photo(self):
        return self._says_ok(0x30)

    def save_screenshot(self):
        return self._says_ok(0x39)

    def save_model(self, number):
        return self._says_ok(0x32, bytes([number, 0]))

    def load_model(self, number):
        return self._says_ok(0x33, bytes([number, 0]))
