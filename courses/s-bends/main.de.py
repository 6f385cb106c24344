# Kurven und S
# Die Kurven sind enger als jeder Bogen. Darum dreht der Roboter an Ort, sobald er von der Linie kommt.
# Sieht kein Sensor mehr die Linie, dreht er weiter zu der Seite, wo sie zuletzt war.
from mbrobot import *

setSpeed(35)
last = left             # die Seite, auf der die Linie zuletzt war

while True:
    left_dark = irLeft.read_digital() == 0
    right_dark = irRight.read_digital() == 0
    if left_dark and right_dark:
        forward()
    elif left_dark:
        left()
        last = left
    elif right_dark:
        right()
        last = right
    else:
        last()          # left oder right
    delay(5)
