# Probe: radio. Put it on two boards; press button A on the one whose output is kept. See README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

import radio

GROUP = 42
radio.config(group=GROUP, length=251, queue=10)
radio.on()


def echo():
    """The other board sends everything back."""
    while not button_a.was_pressed():
        packet = radio.receive_bytes()
        if packet is not None:
            radio.send_bytes(packet)


def round_trip_us(length):
    """Mean time to the answer, and how many of 50 never came."""
    lost, total = 0, 0
    for turn in range(50):
        before = time.ticks_us()
        radio.send_bytes(bytes([turn]) * length)
        while radio.receive_bytes() is None:
            if time.ticks_diff(time.ticks_us(), before) > 200000:
                lost += 1
                break
        else:
            total += time.ticks_diff(time.ticks_us(), before)
    return (total / (50 - lost) if lost < 50 else -1), lost


if not button_a.is_pressed():
    display.show(Image.DIAMOND)
    echo()
display.show(Image.TARGET)
print("probe;begin;radio;1;%s" % os.uname().machine)
for length in (1, 32, 251):
    us, lost = round_trip_us(length)
    row("round trip of %d bytes" % length, "us", "%.0f" % us)
    row("lost of 50 with %d bytes" % length, "items", lost)
before = time.ticks_us()
for turn in range(20):
    radio.send("0123456789")
row("send of 10 characters", "us", "%.0f" % (time.ticks_diff(time.ticks_us(), before) / 20))
print("probe;end;radio;%d" % len(rows))
