# Probe: the Cutebot. It turns its wheels: hold it up, and switch its battery on. Put a book 20 cm ahead of its sensor and
# a white sheet below its line sensors. What is to be seen besides the table: docs/hardware/cutebot.md.
import os, time
from microbit import *
import machine


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


def tried(work):
    """What comes of it, or the error."""
    try:
        return work()
    except OSError as problem:
        return repr(problem)


def sent(*frame):
    i2c.write(0x10, bytes(frame))
    return "taken"


def motors(speed):
    for wheel in (1, 2):
        i2c.write(0x10, bytes((wheel, 2, speed, 0)))


def pulled(pin):
    """The levels of a pin with a pull-up, a pull-down and none."""
    levels = ""
    for pull in (pin.PULL_UP, pin.PULL_DOWN, pin.NO_PULL):
        pin.set_pull(pull)
        sleep(5)
        levels += str(pin.read_digital())
    return levels


def echo():
    pin8.write_digital(1)
    pin8.write_digital(0)
    return machine.time_pulse_us(pin12, 1, 50000)


print("probe;begin;cutebot;1;%s" % os.uname().machine)
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("four bytes read", "text", tried(lambda: "".join("%02x" % value for value in i2c.read(0x10, 4))))
row("write of four bytes", "us", took_us(lambda: sent(1, 2, 0, 0)))

row("left line sensor on white", "text", pulled(pin13))
row("right line sensor on white", "text", pulled(pin14))
row("infrared receiver at rest", "text", pin16.read_digital())
row("echo is low at rest", "text", pin12.read_digital())
print("Look: an echo of %d us for 20 cm" % echo())
print("Take the book away: nothing within 5 m ahead.")
sleep(6000)
row("echo without a target", "us", echo())

row("frame of three bytes", "text", tried(lambda: sent(1, 2, 60)))
print("Look: does the left wheel turn? (three bytes)")
sleep(2000)
motors(0)
row("frame of five bytes", "text", tried(lambda: sent(2, 2, 60, 0, 0)))
print("Look: does the right wheel turn? (five bytes)")
sleep(2000)
motors(0)
row("speed beyond 100", "text", tried(lambda: sent(1, 2, 206, 0)))
print("Look: does the left wheel turn, and as fast as at 100? (206)")
sleep(2000)
motors(100)
sleep(2000)
motors(0)

print("Look: which lamp is red (4), which one blue (8)?")
sent(4, 255, 0, 0)
sent(8, 0, 0, 255)
sleep(4000)
row("frame 12, both lamps", "text", tried(lambda: sent(12, 0, 255, 0)))
print("Look: are both lamps green? (12)")
sleep(3000)
sent(4, 0, 0, 0)
sent(8, 0, 0, 0)

print("Look: at which number does a wheel begin to turn?")
for speed in range(8, 29, 2):
    display.show(speed, delay=300)
    motors(speed)
    sleep(700)
motors(0)
print("probe;end;cutebot;%d" % len(rows))
