# Probe: the MotionKit 2. It turns its motors for a second, and its servos: hold it up. See README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []


def took_us(work):
    """Time of one call, in µs: the mean of twenty."""
    before = time.ticks_us()
    for turn in range(20):
        work()
    return "%.0f" % (time.ticks_diff(time.ticks_us(), before) / 20)


def write(*message):
    i2c.write(0x10, bytes(message))


def read(register, count, pause=0):
    """What stands there, as hexadecimal digits."""
    try:
        write(register)
        sleep(pause)
        return "".join("%02x" % value for value in i2c.read(0x10, count))
    except OSError as problem:
        return repr(problem)


def kept(register, *values):
    """What stands there after a write."""
    write(register, *values)
    return read(register, len(values))


print("probe;begin;motionkit_2;1;%s" % os.uname().machine)
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("version", "text", read(0x32, 21))
row("motors at rest", "text", read(0x00, 4))
row("write of three bytes", "us", took_us(lambda: write(0x00, 0, 0)))
row("read of one byte", "us", took_us(lambda: i2c.read(0x10, 1)))
row("motors while they turn", "text", kept(0x00, 0, 60, 0, 60))
sleep(1000)
write(0x00, 0, 0, 0, 0)
row("lights written 7", "text", kept(0x0B, 7, 0))
write(0x0B, 0, 0)
row("servos written 90 and 200", "text", kept(0x14, 90, 200))
row("colour written 1, 2, 3", "text", kept(0x18, 1, 2, 3))
write(0x18, 0, 0, 0)
row("line bits in the air", "text", read(0x1D, 1))
row("brightness in the air, 0x1E to 0x21", "text", read(0x1E, 4))
row("distance towards nothing, at once", "text", read(0x28, 2))
row("distance towards nothing, after 20 ms", "text", read(0x28, 2, 20))
row("distance, low byte alone", "text", read(0x29, 1))
row("infrared, no key", "text", read(0x2B, 4))
for first, count in ((0x04, 7), (0x0D, 7), (0x16, 2), (0x1B, 2), (0x22, 6), (0x2A, 1), (0x2F, 3), (0x48, 16)):
    row("others from 0x%02X" % first, "text", read(first, count))
print("probe;end;motionkit_2;%d" % len(rows))
