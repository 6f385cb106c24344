# La porta scorrevole
# Alla linea nera il robot aspetta che la porta sia chiusa e che si riapra.
# Così ha più tempo possibile per passare.
from mbrobot import *

FREE = 50               # centimetri: la porta non è mai così lontana

def distance():
    """La più piccola di tre misure: se un'eco si perde, getDistance() dà 255."""
    return min(getDistance(), getDistance(), getDistance())

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()

setLED(1)
while distance() > FREE:        # aperta, ma per quanto?
    delay(20)
while distance() < FREE:        # chiusa
    delay(20)
setLED(0)

forward()
delay(2900)
stop()
fillRGB(0, 80, 0)       # fatto!
