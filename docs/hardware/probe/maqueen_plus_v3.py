# Probe: the Maqueen Plus V3 with its lidar. It turns its wheels: hold it up, level, with nothing in front of it. Switch the
# robot on when this program is on the board. What is to be seen besides the table: docs/hardware/maqueen-plus-v3.md.
import os, time
from microbit import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []


def tried(work):
    """What comes of it, or the error."""
    try:
        return work()
    except OSError as problem:
        return repr(problem)


def hexed(data):
    return "".join("%02x" % value for value in data)


def put(*values):
    i2c.write(0x10, bytes(values))


def read(register, count):
    i2c.write(0x10, bytes([register]))
    return i2c.read(0x10, count)


def asked(*request):
    """The reply of the lidar to a request, up to 12 bytes, once it is no FF; at most 300 ms later."""
    i2c.write(0x33, bytes(request))
    for turn in range(60):
        first = i2c.read(0x33, 1)
        if first[0] != 0xFF:
            return hexed(first + i2c.read(0x33, 11))
        sleep(5)
    return "nothing"


def waited():
    """Time until the lidar answers at its address, in ms since the board has started."""
    while running_time() < 10000:
        if 0x33 in i2c.scan():
            return running_time()
        sleep(20)
    return "never"


print("probe;begin;maqueen_plus_v3;1;%s" % os.uname().machine)
row("lidar is there after", "ms", waited())
row("addresses", "text", " ".join("%02x" % address for address in i2c.scan()))
row("version length", "text", tried(lambda: hexed(read(50, 1))))
row("version", "text", tried(lambda: hexed(read(51, 20))))
row("registers 0 to 15", "text", tried(lambda: hexed(read(0, 16))))
row("registers 60 to 73", "text", tried(lambda: hexed(read(60, 14))))
row("registers 85 to 92", "text", tried(lambda: hexed(read(85, 8))))
row("line sensors in the air", "text", tried(lambda: hexed(read(29, 11))))


def flags():
    """Register 87 every 200 ms while the wheels go 10 cm, and then a moment longer."""
    put(64, 1)
    put(85, 2)
    put(65, 0)
    put(66, 10)
    put(60, 6)
    seen = ""
    for turn in range(10):
        seen += str(read(87, 1)[0])
        sleep(200)
    return seen


row("87 while 10 cm are driven", "text", tried(flags))
row("speeds after [76, 1], at rest", "text", tried(lambda: (put(76, 1), hexed(i2c.read(0x10, 2)))[1]))
row("a second read without a register", "text", tried(lambda: (read(50, 1), hexed(i2c.read(0x10, 1)))[1]))


def answers_again():
    """Time from a reset until the robot answers, in ms."""
    put(73, 1)
    before = time.ticks_ms()
    while time.ticks_diff(time.ticks_ms(), before) < 2000:
        try:
            read(50, 1)
            return time.ticks_diff(time.ticks_ms(), before)
        except OSError:
            sleep(1)
    return "never"


row("answers after a reset", "ms", tried(answers_again))
row("lidar, cell 3 0", "text", tried(lambda: asked(0x55, 0, 3, 3, 3, 0)))
row("lidar, n without the command", "text", tried(lambda: asked(0x55, 0, 2, 3, 3, 0)))
row("lidar, 4 with a row", "text", tried(lambda: asked(0x55, 0, 2, 4, 0)))
row("lidar, 5 with a column", "text", tried(lambda: asked(0x55, 0, 2, 5, 0)[:8]))
row("lidar, 6 with a row", "text", tried(lambda: asked(0x55, 0, 2, 6, 0)))
row("lidar, 6 alone, 8 x 8", "text", tried(lambda: asked(0x55, 0, 1, 6)[:8]))
row("lidar, no such cell", "text", tried(lambda: asked(0x55, 0, 3, 3, 8, 8)))
row("lidar, no such command", "text", tried(lambda: asked(0x55, 0, 1, 99)))
row("lidar, mode", "text", tried(lambda: asked(0x55, 0, 5, 1, 0, 0, 0, 8)))
print("probe;end;maqueen_plus_v3;%d" % len(rows))

print("Look: light on the left and on the right, high byte first: %s" % hexed(read(78, 4)))
print("Look: hold a hand at the left edge, 10 cm ahead, at eye level. Which cells are near?")
sleep(6000)
i2c.write(0x33, b"\x55\x00\x01\x02")
sleep(40)
data = i2c.read(0x33, 4) + i2c.read(0x33, 128)
for y in range(8):
    print(" ".join("%4d" % (data[4 + 16 * y + 2 * x] | data[5 + 16 * y + 2 * x] << 8) for x in range(8)))
