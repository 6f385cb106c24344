# Wanders about, turns away from what is near, polls the ultrasonic echo itself and draws random numbers.
import math
import random
from microbit import display, pin1, pin2, running_time, sleep
from mbrobot import backward, fillRGB, forward, irLeft, left, right, setSpeed, stop
from utime import ticks_diff, ticks_us


def echo_us():
    pin1.write_digital(1)
    pin1.write_digital(0)
    started = ticks_us()
    while pin2.read_digital() == 0:
        if ticks_diff(ticks_us(), started) > 5000:
            return 30000
    began = ticks_us()
    while pin2.read_digital() == 1:
        pass
    return ticks_diff(ticks_us(), began)


while running_time() < 18000:
    near = echo_us() < 700
    setSpeed(random.randint(30, 90))
    if near:
        backward()
        sleep(300)
        (left if random.random() < 0.5 else right)()
        sleep(random.randrange(150, 450))
    else:
        forward()
        sleep(60)
    fillRGB(int(40 + 40 * math.sin(running_time() / 500)), 0, 20 * irLeft.read_digital())
    display.set_pixel(random.randrange(5), random.randrange(5), 9)
stop()
