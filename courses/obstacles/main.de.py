# Hindernissen ausweichen
# Der Ultraschall misst den Abstand nach vorne in Zentimetern.
# Er sieht wie der Strahl einer Taschenlampe: Was daneben steht, bleibt unsichtbar.
# Wo der Weg endet, schaut der Roboter darum auch nach links und nach rechts.
from mbrobot import *

NEAR = 22               # Zentimeter: näher fährt er an nichts heran
FREE = 50               # Zentimeter: so weit soll der neue Weg frei sein
LOOK = 110              # Millisekunden Drehung für einen Blick zur Seite

def turn(direction):
    direction()         # left oder right
    delay(LOOK)
    stop()
    delay(40)           # ruhig stehen, dann erst messen

def look(direction, back):
    """Abstand neben dem Roboter; danach schaut er wieder nach vorne."""
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
        turn(direction)     # immer gleich herum, sonst pendelt er in einer Ecke
        far = far - 3       # wer lange sucht, ist mit weniger zufrieden
