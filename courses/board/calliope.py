# Calliope mini: colour lights and motors
# A switches the motors on and off, B changes the colour.
from calliopemini import *
import neopixel

lights = neopixel.NeoPixel(pin_RGB, 3)
colors = [(60, 0, 0), (0, 60, 0), (0, 0, 60), (60, 40, 0)]
color = 0
running = False

while True:
    if button_b.was_pressed():
        color = (color + 1) % len(colors)
    for place in range(3):
        lights[place] = colors[(color + place) % len(colors)]
    lights.show()

    if button_a.was_pressed():
        running = not running
        pin_M_MODE.write_digital(1)           # motors ready
        pin_M0_DIR.write_digital(0)           # 0: forwards
        pin_M1_DIR.write_digital(0)
        pin_M0_SPEED.write_analog(600 if running else 0)
        pin_M1_SPEED.write_analog(600 if running else 0)
    sleep(50)
