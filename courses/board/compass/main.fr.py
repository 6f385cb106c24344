# Aiguille de boussole
# L'aiguille montre le nord. Ouvre les capteurs et tourne la boussole.
from microbit import *

needles = Image.ALL_CLOCKS         # 12 aiguilles, dans le sens des aiguilles d'une montre

while True:
    heading = compass.heading()    # 0 est le nord, 90 l'est
    number = (360 - heading + 15) // 30 % 12
    display.show(needles[number])
    print('Cap :', heading)
    sleep(200)
