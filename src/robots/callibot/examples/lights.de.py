# Lichter
# Vorn hat der Roboter zwei rote Lichter, unten vier farbige.
# Für die farbigen gibt es in callibot keinen Befehl:
# Das Programm schickt die Bytes selbst.
from calliope_mini import *
from callibot import *


def color(light, red, green, blue):
    # Licht 1 vorn links, 2 hinten links, 3 hinten rechts, 4 vorn rechts
    # Rot, Grün, Blau: je 0 bis 16
    i2c.write(0x22, bytes([3, light, red, green, blue]))


colors = [(16, 0, 0), (16, 8, 0), (0, 16, 0), (0, 10, 16), (0, 0, 16), (10, 0, 16)]

display.show(Image.HAPPY)

for red, green, blue in colors:
    for light in range(1, 5):
        color(light, red, green, blue)
    delay(500)

for turn in range(12):      # ein Licht läuft im Kreis
    for light in range(1, 5):
        color(light, 0, 0, 0)
    color(turn % 4 + 1, 0, 16, 8)
    if turn % 2 == 0:
        setLEDLeft(1)       # schaltet zugleich das rechte aus
    else:
        setLEDRight(1)
    delay(200)

i2c.write(0x22, bytes([1]))  # alles aus
