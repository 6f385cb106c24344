# Il giro
# Compito: passa per i punti di controllo da 1 a 5, poi va' all'arrivo.
# leftArc(0.2) e rightArc(0.2) percorrono archi con raggio di 20 cm. Quanto dura un quarto di cerchio?
from callibot import *

setSpeed(20)

forward()
delay(2600)
leftArc(0.2)
delay(1000)
stop()
# E poi?
