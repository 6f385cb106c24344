# Hindernissen ausweichen
# Der Ultraschall misst den Abstand nach vorne in Zentimetern.
# Er sieht wie der Strahl einer Taschenlampe: Was daneben steht, bleibt unsichtbar.
# Darum schaut der Roboter vor dem Weiterfahren auch ein wenig nach links und nach rechts.
from mbrobot import *

NEAR = 22               # Zentimeter: näher fährt er an nichts heran
LOOK = 130              # Millisekunden Drehung für einen Blick zur Seite
STEP = 500              # Millisekunden Fahrt zwischen zwei Blicken

def turn(direction, milliseconds):
    direction()         # left oder right
    delay(milliseconds)
    stop()
    delay(40)           # ruhig stehen, dann erst messen

def look():
    """Abstände links, vorne und rechts."""
    turn(left, LOOK)
    on_the_left = getDistance()
    turn(right, LOOK)
    ahead = getDistance()
    turn(right, LOOK)
    on_the_right = getDistance()
    turn(left, LOOK)
    return on_the_left, ahead, on_the_right

setSpeed(40)

while True:
    distances = look()
    if min(distances) > NEAR:
        setLED(0)
        forward()
        delay(STEP)
        stop()
    else:
        setLED(1)
        direction = left if distances[0] > distances[2] else right
        while min(distances) <= NEAR:   # immer gleich herum, sonst pendelt er in einer Ecke
            turn(direction, 2 * LOOK)
            distances = look()
