# Probe: the bit:bot XL. It turns its motors for a second: hold it up. See README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

import machine


def took_us(work):
    """Time of one call, in µs: the mean of twenty."""
    before = time.ticks_us()
    for turn in range(20):
        work()
    return "%.0f" % (time.ticks_diff(time.ticks_us(), before) / 20)


def read(address, count, *place):
    """What stands there, as hexadecimal digits; without a place what comes by itself."""
    try:
        if place:
            i2c.write(address, bytes(place))
        return "".join("%02x" % value for value in i2c.read(address, count))
    except OSError as problem:
        return repr(problem)


print("probe;begin;bitbot_xl;1;%s" % os.uname().machine)
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("line byte in the air", "text", read(0x1C, 1))
row("four line bytes at once", "text", read(0x1C, 4))
row("outputs of the expander", "text", read(0x1C, 1, 1))
row("inputs it turns round", "text", read(0x1C, 1, 2))
row("pins that are inputs", "text", read(0x1C, 1, 3))
row("line byte after register 0", "text", read(0x1C, 1, 0))
row("bias in the memory", "text", read(0x50, 3, 0, 0))
row("read of one line byte", "us", took_us(lambda: i2c.read(0x1C, 1)))
row("write of a motor pin", "us", took_us(lambda: pin16.write_analog(0)))

for pins in ((pin16, pin14), (pin8, pin12)):
    for pin in pins:
        pin.write_analog(300)
    sleep(500)
    for pin in pins:
        pin.write_analog(0)
row("line byte after driving", "text", read(0x1C, 1))


def trigger():
    pin15.write_digital(1)
    time.sleep_us(10)
    pin15.write_digital(0)
    pin15.set_pull(pin15.NO_PULL)


trigger()
begin = time.ticks_us()
while pin15.read_digital() == 0 and time.ticks_diff(time.ticks_us(), begin) < 100000:
    pass
row("wait for the echo, towards nothing", "us", time.ticks_diff(time.ticks_us(), begin))
sleep(100)
trigger()
row("echo towards nothing", "us", machine.time_pulse_us(pin15, 1, 100000))
sleep(100)
pin15.set_pull(pin15.PULL_UP)
row("ultrasonic wire pulled up at rest", "text", pin15.read_digital())
pin15.set_pull(pin15.NO_PULL)
row("light left, right", "text", "%d %d" % (pin2.read_analog(), pin1.read_analog()))
print("probe;end;bitbot_xl;%d" % len(rows))
