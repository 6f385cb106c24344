# Spingere il blocco
# Quando i sensori di linea vedono la linea nera, il blocco davanti al robot è già nella zona.
from mbrobot import *

setSpeed(50)

forward()
while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
    delay(10)
stop()
delay(300)

backward()              # il blocco resta dov'è
delay(1000)
stop()
fillRGB(0, 80, 0)       # fatto!
