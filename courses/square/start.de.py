# Das Quadrat
# Auftrag: Fahr ein Quadrat mit 40 cm Seite und komm zurück zum Start.
# Wie lange dauert eine Seite, wie lange eine Ecke? Probiere aus und miss.
from mbrobot import *

setSpeed(50)

forward()
delay(1000)             # Millisekunden
stop()
delay(200)
left()
delay(300)
stop()
# Wie fährt der Roboter das viermal? Tipp: for i in range(4):
