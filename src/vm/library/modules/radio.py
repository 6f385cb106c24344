# The module radio. Behaviour and errors: micropython-microbit-v2 modradio.c, drv_radio.c.
import _hal as _h
from _sim import addressof as _addressof, ints as _ints, on_import as _on_import, raw as _raw, text as _text, unchecked_text as _unchecked_text

_waiting = _h.radio_waiting
_take = _h.radio_take

RATE_1MBIT = 0
RATE_2MBIT = 1

_TEXT = b"\x01\x00\x01"
# On the device the queue lies on the heap: it takes as much here.
_queue = None


def _allocate():
    global _queue
    _queue = None
    _queue = bytearray(_h.radio_buffer())


def _check(enabled):
    if not enabled:
        raise ValueError("radio is not enabled")


def on():
    _h.radio_off()
    _allocate()
    _h.radio_on()


def off():
    global _queue
    _queue = None
    _h.radio_off()


def reset():
    _h.radio_forget()


def config(*args, **kwargs):
    if args:
        raise TypeError("arguments must be keywords")
    for name, value in kwargs.items():
        try:
            # As many bits as the device has; more would not reach the simulation.
            value = ((value + 0x80000000) & 0xFFFFFFFF) - 0x80000000
        except TypeError:
            _ints(value)
        result = _h.radio_set(name, value)
        if result:
            _h.radio_discard()
            raise ValueError(("unknown argument '%s'" if result == -1 else "value out of range for argument '%s'") % name)
    _h.radio_apply()
    if _h.radio_is_on() and len(_queue) != _h.radio_buffer():
        on()


def send(message):
    if not isinstance(message, bytes):
        _text(message)
        message = message.encode()
    packet = _TEXT + message
    _check(_h.radio_send(_addressof(packet), len(packet)))


def send_bytes(message):
    packet = _raw(message)
    _check(_h.radio_send(_addressof(packet), len(packet)))


def _oldest(length):
    """The oldest message, which is so long; None if there is none."""
    while length >= 0:
        message = bytearray(length)
        if _take(_addressof(message), length) == length:
            return bytes(message)
        # A callback in between has taken it: look again.
        length = _waiting()
    _check(length == -1)
    return None


def receive_bytes():
    return _oldest(_waiting())


def receive_bytes_into(buffer):
    if isinstance(buffer, (str, bytes)):
        raise TypeError("object with buffer protocol required")
    room = len(_raw(buffer))
    message = _oldest(_waiting())
    if message is None:
        return None
    length = min(room, len(message))
    _h.radio_copy(_addressof(buffer), _addressof(message), length)
    return len(message)


def receive():
    length = _waiting()
    # Programs ask again and again, mostly in vain.
    message = None if length == -1 else _oldest(length)
    if message is None:
        return None
    if message[:3] != _TEXT:
        raise ValueError("received packet is not a string")
    # Unchecked: the sender's radio may have cut the text inside a sign.
    return _unchecked_text(message[3:])


def receive_full():
    message = _oldest(_waiting())
    if message is None:
        return None
    return (message, _h.radio_rssi(), _h.radio_time())


def _begin():
    reset()
    on()


_on_import["radio"] = _begin
