# Garder la distance
# Le robot roule jusqu'à 10 cm du mur et retient combien de temps il a mis.
# En marche arrière, il faut le même temps.
from microbit import running_time
from mbrobot import *

setSpeed(50)

start = running_time()
forward()
while getDistance() > 10:
    delay(10)
stop()
way = running_time() - start

beep()
print("Temps de trajet :", way, "ms")
delay(500)

backward()
delay(way)
stop()
