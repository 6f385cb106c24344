# Probe: how long calls take. Prints a table of µs per call; see README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

CALLS = (
    "pass", "x += 1", "x * 3.5", "len(s)", "button_a.is_pressed()", "button_a.was_pressed()", "button_b.get_presses()",
    "pin0.read_digital()", "pin0.write_digital(1)", "pin1.read_analog()", "pin1.write_analog(512)", "pin2.is_touched()",
    "pin_logo.is_touched()", "pin0.get_mode()", "display.set_pixel(2, 2, 9)", "display.get_pixel(2, 2)",
    "display.show(im)", "display.show(Image.HEART)", "display.show(3)", "display.show('A')", "display.show(im * 5)",
    "display.clear()", "display.is_on()", "display.read_light_level()", "im.get_pixel(1, 1)", "im.set_pixel(1, 1, 5)",
    "im.copy()", "im.invert()", "im.fill(3)", "im.shift_left(1)", "im.crop(1, 1, 3, 3)",
    "im.blit(im2, 0, 0, 5, 5, 1, 1)", "im + im2", "im * 5", "Image('99999:00000:99999:00000:99999')", "Image(5, 5)",
    "str(im)", "accelerometer.get_x()", "accelerometer.get_values()", "accelerometer.current_gesture()",
    "compass.heading()", "temperature()", "microphone.sound_level()", "running_time()", "time.ticks_us()",
    "scale(5, from_=(0, 10), to=(0, 1023))", "np.fill((1, 2, 3))", "np[0] = (1, 2, 3)", "np.show()",
    "music.pitch(440, wait=False)", "music.stop()", "radio.receive()", "radio.send('hi')", "random.randint(1, 6)",
    "'{} {:.2f}'.format(3, 1.5)", "gc.collect()", "sum(l)", "sorted(l)", "99 in l", "l[10:90]", "','.join(t)",
    "s.find('z')", "big * big", "str(big)", "d[50]", "l.index(99)", "bytes(b)",
)
SETUP = """
import gc, time, music, neopixel, radio, random
im = Image("11111:22222:33333:44444:55555")
im2 = im.copy()
np = neopixel.NeoPixel(pin8, 8)
radio.on()
x = 1
l = list(range(100))
t = ["ab"] * 50
s = "abcdefghij" * 20
b = bytearray(200)
big = 3 ** 200
d = dict((i, i) for i in range(100))
"""
LEAST_US = 50000


def loop_us(call, count):
    """Time of so many rounds, in µs."""
    names = dict(globals())
    exec(SETUP, names)
    exec("def f(n):\n global x\n for i in range(n):\n  " + call, names)
    gc.collect()
    before = time.ticks_us()
    names["f"](count)
    return time.ticks_diff(time.ticks_us(), before)


print("probe;begin;timing;1;%s" % os.uname().machine)
empty = loop_us("pass", 4000) / 4000
for call in CALLS:
    try:
        count = 8
        us = loop_us(call, count)
        while us < LEAST_US and count < 8000:
            count *= 4
            us = loop_us(call, count)
        row(call, "us", "%.1f" % (us / count - (0 if call == "pass" else empty)))
    except Exception as problem:
        row(call, "text", repr(problem))
print("probe;end;timing;%d" % len(rows))
