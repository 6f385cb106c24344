# Probe: what errors say. Prints statements and their exceptions; see README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

import music, radio

STATEMENTS = (
    "1 / 0", "int('x')", "float('x')", "[][1]", "{}['a']", "'3' + 4", "3 + '4'", "nix", "Image.NIX", "display.nix()",
    "display.show()", "display.show(None)", "display.set_pixel(9, 0, 1)", "display.set_pixel(0, 0, 10)",
    "display.set_pixel(0, 0)", "display.get_pixel(-1, 0)", "Image('abc')", "Image(2, 2, b'1')", "Image(-1, 1)",
    "Image.HEART.set_pixel(0, 0, 1)", "pin0.write_digital(2)", "pin0.write_analog(2000)", "pin0.set_analog_period(0)",
    "pin3.read_analog()", "button_a.nix", "sleep('x')", "sleep(-1)", "music.play('z9')", "music.play(5)",
    "music.pitch(-100)", "music.pitch = 4", "music.set_tempo(bpm=0)", "radio.config(group=300)", "radio.send(5)",
    "radio.send('x' * 300)", "i2c.read(0x55, 1)", "i2c.write(0x55, b'1')", "len(5)", "abs('x')", "chr(-1)", "ord('ab')",
    "(lambda a: a)()", "(lambda: 0)(1)", "(lambda a: a)(b=1)", "range(1, 2, 0)", "'%d' % 'x'", "'{}'.format()",
    "[1, 2].remove(3)", "(1, 2)[0] = 3", "a, b = 1, 2, 3", "a, b = 1", "import nix", "from microbit import nix",
    "raise ValueError", "assert False", "f(", "x = = 1", "if True print(1)", "for i in 5: pass", "next(iter([]))",
    "del nix", "open('nix')", "bytearray(100000)", "'x' * 100000", "2 ** 'x'", "compass.calibrate(1)",
    "accelerometer.is_gesture('nix')", "display.scroll()", "scale(1)", "int([])",
)

print("probe;begin;errors;1;%s" % os.uname().machine)
for statement in STATEMENTS:
    said = "nothing"
    try:
        exec(statement, dict(globals()))
    except Exception as problem:
        said = "%s: %s" % (type(problem).__name__, problem)
    row(statement, "text", said)
for thing in ("print", "len", "Image", "display", "music", "row", "[].append", "pin0", "button_a", "os", "Image.HEART"):
    row("repr " + thing, "text", repr(eval(thing)).split(" at 0x")[0])
print("probe;end;errors;%d" % len(rows))
