# Counter with buttons
# A counts on, B starts again, A and B together write the count down.
from microbit import *

count = 0
display.show(count)

while True:
    if button_a.is_pressed() and button_b.is_pressed():
        print('Count:', count)
        sleep(500)
    elif button_a.was_pressed():
        count = count + 1
        display.show(count)
    elif button_b.was_pressed():
        count = 0
        display.show(count)
    sleep(20)
