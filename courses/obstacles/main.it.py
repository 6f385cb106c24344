# Evitare gli ostacoli
# Il sensore a ultrasuoni misura la distanza dritto davanti, in centimetri.
# Vede come il fascio di una torcia: ciò che sta accanto al fascio resta nascosto.
# Perciò dove la via finisce il robot guarda anche a sinistra e a destra.
from mbrobot import *

NEAR = 22               # centimetri: più vicino non va
FREE = 50               # centimetri: fin lì la nuova via dev'essere libera
LOOK = 110              # millisecondi di rotazione per uno sguardo di lato

def turn(direction):
    direction()         # sinistra o destra
    delay(LOOK)
    stop()
    delay(40)           # fermarsi, poi misurare

def look(direction, back):
    """Distanza accanto al robot; poi guarda di nuovo avanti."""
    turn(direction)
    distance = getDistance()
    turn(back)
    return distance

def is_free(far):
    return getDistance() > far and look(left, right) > NEAR and look(right, left) > NEAR

setSpeed(50)

while True:
    setLED(0)
    forward()
    while getDistance() > NEAR:
        delay(20)
    stop()

    setLED(1)
    direction = left if look(left, right) > look(right, left) else right
    turn(direction)
    far = FREE
    while not is_free(far):
        turn(direction)     # sempre nello stesso verso, se no in un angolo resterebbe indeciso
        far = far - 3       # chi cerca a lungo si accontenta di meno
