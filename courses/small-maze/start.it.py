# Attraverso il labirinto
# Compito: segui il corridoio fino alla linea nera dell'arrivo.
# Il sensore a ultrasuoni misura solo davanti. Davanti a un muro il robot deve guardarsi attorno.
from mbrobot import *

QUARTER_TURN = 372      # millisecondi per 90 gradi con setSpeed(50)

setSpeed(50)
forward()
while getDistance() > 6:
    delay(10)
stop()
delay(200)
left()
delay(QUARTER_TURN)
stop()
# Una curva è fatta. Come diventa un programma per tutto il labirinto?
