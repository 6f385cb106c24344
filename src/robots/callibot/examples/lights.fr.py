# Lumières
# Le robot a deux lumières rouges à l'avant et quatre de couleur en dessous.
# callibot n'a pas de commande pour celles de couleur :
# le programme envoie lui-même les octets.
from calliope_mini import *
from callibot import *


def color(light, red, green, blue):
    # lumière 1 avant gauche, 2 arrière gauche, 3 arrière droite, 4 avant droite
    # rouge, vert, bleu : chacun de 0 à 16
    i2c.write(0x22, bytes([3, light, red, green, blue]))


colors = [(16, 0, 0), (16, 8, 0), (0, 16, 0), (0, 10, 16), (0, 0, 16), (10, 0, 16)]

display.show(Image.HAPPY)

for red, green, blue in colors:
    for light in range(1, 5):
        color(light, red, green, blue)
    delay(500)

for turn in range(12):      # une lumière tourne en rond
    for light in range(1, 5):
        color(light, 0, 0, 0)
    color(turn % 4 + 1, 0, 16, 8)
    if turn % 2 == 0:
        setLEDLeft(1)       # éteint aussi la droite
    else:
        setLEDRight(1)
    delay(200)

i2c.write(0x22, bytes([1]))  # tout éteint
