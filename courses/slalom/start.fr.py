# Slalom
# Tâche : contourne les poteaux jusqu'à l'arrivée sans les toucher.
# rightArc(0.2) roule un arc à droite d'un rayon de 20 cm. Combien de temps dure un demi-cercle ?
from mbrobot import *

setSpeed(50)

rightArc(0.2)
delay(2000)             # millisecondes : pas encore assez
stop()
# Et comment contourner le poteau suivant ?
