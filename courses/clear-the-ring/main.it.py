# Svuotare il cerchio
# Il robot gira sul posto finché vede un blocco, gli va incontro e lo spinge oltre il cerchio nero.
# Quando un giro intero non mostra più blocchi, il cerchio è vuoto.
from mbrobot import *

FAR = 28                # centimetri: ciò che è più lontano è fuori dal cerchio
FULL_TURN = 60          # tante piccole rotazioni fanno più di un giro
TO_MIDDLE = 1600        # millisecondi dalla linea al centro

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

def look_around():
    """Gira finché vede un blocco. False: non ce n'è."""
    for i in range(FULL_TURN):
        if getDistance() < FAR:
            return True
        left()
        delay(35)
        stop()
        delay(40)       # fermarsi, poi misurare
    return False

def push_out():
    """Spinge ciò che è davanti oltre la linea e torna al centro."""
    forward()
    while not on_line():
        delay(5)
    delay(350)          # il blocco è davanti al robot: ancora un po'
    backward()
    while not on_line():
        delay(5)
    while on_line():
        delay(5)
    delay(TO_MIDDLE)
    stop()

setSpeed(45)
count = 0
while look_around():
    left()              # il fascio è largo: girare fino al suo centro
    delay(60)
    stop()
    push_out()
    count += 1
    print("spinti fuori:", count)

stop()
fillRGB(0, 80, 0)       # fatto!
