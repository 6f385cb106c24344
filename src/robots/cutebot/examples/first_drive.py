# First drive
# Forward, a bend, backward. Change the numbers and see what happens!
from microbit import *
from cutebot import *

set_left_rgb_led(255, 255, 255)
set_right_rgb_led(255, 255, 255)

go_forward()
sleep(700)
set_motors_speed(40, 20)        # the left wheel is faster: a bend to the right
sleep(600)
turn_left()                     # turns on the spot
sleep(400)
go_backward()
sleep(500)
stop()

set_left_rgb_led(0, 0, 0)
set_right_rgb_led(0, 0, 0)
