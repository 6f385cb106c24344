# Lights
# The robot has two headlamps in front and two lights below, at pin 15.
from microbit import *
from neopixel import NeoPixel
from cutebot import *

below = NeoPixel(pin15, 2)
colors = [(255, 0, 0), (255, 160, 0), (0, 255, 0), (0, 200, 255), (0, 0, 255)]

for color in colors:                    # all four alike
    set_left_rgb_led(*color)
    set_right_rgb_led(*color)
    below[0] = color
    below[1] = color
    below.show()
    sleep(500)

below.clear()
set_right_rgb_led()
set_motors_speed(-20, 20)
for blink in range(4):                  # an indicator while it turns
    set_left_rgb_led(255, 120, 0)
    sleep(250)
    set_left_rgb_led()
    sleep(250)
stop()
