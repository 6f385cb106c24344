# The module power. Behaviour and errors: micropython-microbit-v2 modpower.c.
import _hal as _h
from _pins import MicroBitButton as _Button, MicroBitDigitalPin as _Pin, MicroBitTouchOnlyPin as _TouchPin
from _sim import ints as _ints


def off():
    _h.run_every_stop()
    while True:
        try:
            # Only a reset ends it. A Ctrl-C does not reach a board that is off; it is raised at the inner loop's jump.
            while True:
                _h.power_off()
        except KeyboardInterrupt:
            pass


def _wake_on(sources):
    _h.power_wake_clear()
    if sources is None:
        return
    for source in sources if isinstance(sources, (tuple, list)) else (sources,):
        if isinstance(source, _Button):
            _h.power_wake_button(source._n)
        elif isinstance(source, (_Pin, _TouchPin)):
            _h.power_wake_pin(source._n)
        else:
            raise ValueError("expecting a pin or button")


def deep_sleep(ms=None, wake_on=None, run_every=True):
    if ms is not None:
        _ints(ms)
        ms &= 0xFFFFFFFF
    _wake_on(wake_on)
    irq = run_every or _h.set_irq(False)
    try:
        state = _h.power_sleep() if ms is None else _h.power_sleep(ms // 1000, ms % 1000)
        while state < 0:
            # A callback came in between and has run: sleep on.
            state = _h.power_sleep_on()
    finally:
        if not run_every:
            _h.set_irq(irq)
