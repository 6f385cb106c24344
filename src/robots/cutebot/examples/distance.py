# Do not bump
# The robot drives until something is nearer than 20 cm.
# Then it turns away.
# Button A stops it.
from microbit import *
from cutebot import CUTEBOT, left, right

ct = CUTEBOT()


def lights(red, green, blue):
    ct.set_car_light(left, red, green, blue)
    ct.set_car_light(right, red, green, blue)


while not button_a.was_pressed():
    distance = ct.get_distance()        # 0 means: nothing there
    if 0 < distance < 20:
        lights(255, 0, 0)
        ct.set_motors_speed(-30, -30)
        sleep(200)
        ct.set_motors_speed(30, -30)
        sleep(350)
    else:
        lights(0, 255, 0)
        ct.set_motors_speed(30, 30)
    sleep(30)

ct.set_motors_speed(0, 0)
lights(0, 0, 0)
