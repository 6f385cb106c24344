# Vider le cercle
# Le robot tourne sur place jusqu'à ce qu'il voie un bloc, roule vers lui et le pousse par-dessus le cercle noir.
# Quand un tour complet ne montre plus de bloc, le cercle est vide.
from mbrobot import *

FAR = 28                # centimètres : ce qui est plus loin est hors du cercle
FULL_TURN = 60          # tant de petites rotations font plus d'un tour
TO_MIDDLE = 1600        # millisecondes de la ligne au milieu

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

def look_around():
    """Tourne jusqu'à voir un bloc. False : il n'y en a pas."""
    for i in range(FULL_TURN):
        if getDistance() < FAR:
            return True
        left()
        delay(35)
        stop()
        delay(40)       # s'arrêter, puis mesurer
    return False

def push_out():
    """Pousse ce qui est devant par-dessus la ligne et revient au milieu."""
    forward()
    while not on_line():
        delay(5)
    delay(350)          # le bloc est devant le robot : encore un peu
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
    left()              # le faisceau est large : tourner jusqu'à son milieu
    delay(60)
    stop()
    push_out()
    count += 1
    print("poussés dehors :", count)

stop()
fillRGB(0, 80, 0)       # réussi !
