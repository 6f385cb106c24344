# La porte coulissante
# Tâche : passe par la porte jusqu'à l'arrivée sans toucher la porte coulissante.
# Conseil : à la ligne d'arrêt, mesure avec getDistance() si la voie est libre.
from mbrobot import *

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()
# Tu es à la ligne d'arrêt. Qu'attends-tu ?
while True:
    print(getDistance(), "cm")
    delay(200)
