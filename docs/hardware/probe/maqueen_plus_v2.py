# Probe: the Maqueen Plus V2. It turns its motors for two seconds: hold it up. See README.md beside this file.
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


print("probe;begin;maqueen_plus_v2;1;%s" % os.uname().machine)
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("version", "text", read(0x10, 0x33, 10))
row("motors at rest", "text", read(0x10, 0x00, 4))
row("write of five bytes", "us", took_us(lambda: i2c.write(0x10, b"\x00\x00\x00\x00\x00")))
row("read of one byte", "us", took_us(lambda: i2c.read(0x10, 1)))
i2c.write(0x10, b"\x00\x00\x30\x00\x30")
sleep(1000)
row("motors while they turn", "text", read(0x10, 0x00, 4))
i2c.write(0x10, b"\x00\x00\x00\x00\x00")


def echo():
    """The ultrasonic sensor, towards nothing."""
    pin13.write_digital(1)
    pin13.write_digital(0)
    return machine.time_pulse_us(pin14, 1, 50000)


row("echo without a target", "us", echo())
row("line sensors in the air", "text", read(0x10, 0x1D, 1))
print("probe;end;maqueen_plus_v2;%d" % len(rows))
