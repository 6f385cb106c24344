# Tenere la distanza
# Compito: va' fino a 10 cm dal muro e torna a marcia indietro alla partenza.
# getDistance() misura la distanza davanti, in centimetri.
from mbrobot import *

setSpeed(50)
forward()
delay(1000)
print(getDistance(), "cm")
# Come fa il robot a continuare finché la distanza è più di 10? Consiglio: while
stop()
