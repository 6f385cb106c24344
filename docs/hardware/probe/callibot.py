# Probe: the Calli:bot. It turns its motors for two seconds: hold it up. See README.md beside this file.
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


def read(address, register, count):
    """What stands there, as hexadecimal digits."""
    try:
        i2c.write(address, bytes([register]))
        return "".join("%02x" % value for value in i2c.read(address, count))
    except OSError as problem:
        return repr(problem)


print("probe;begin;callibot;1;%s" % os.uname().machine)
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("type and firmware", "text", read(0x22, 0x82, 6))
row("switches at rest", "text", read(0x22, 0x80, 1))
row("write of five bytes", "us", took_us(lambda: i2c.write(0x20, b"\x00\x00\x00\x00\x00")))
row("read of one byte", "us", took_us(lambda: i2c.read(0x20, 1)))
i2c.write(0x20, b"\x00\x00\x50\x00\x50")
sleep(1000)
row("battery while the motors turn", "text", read(0x22, 0x83, 3))
i2c.write(0x20, b"\x00\x00\x00\x00\x00")
row("distance towards nothing", "text", read(0x22, 0x81, 3))
row("line sensors in the air", "text", read(0x22, 0x84, 5))
print("probe;end;callibot;%d" % len(rows))
