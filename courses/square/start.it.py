# Il quadrato
# Compito: percorri un quadrato con lato di 40 cm e torna alla partenza.
# Quanto dura un lato, quanto un angolo? Prova e misura.
from mbrobot import *

setSpeed(50)

forward()
delay(1000)             # millisecondi
stop()
delay(200)
left()
delay(300)
stop()
# Come lo fa il robot quattro volte? Consiglio: for i in range(4):
