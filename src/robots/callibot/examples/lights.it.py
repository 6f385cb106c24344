# Luci
# Il robot ha due luci rosse davanti e quattro colorate sotto.
# callibot non ha un comando per quelle colorate:
# il programma manda i byte da sé.
from calliope_mini import *
from callibot import *


def color(light, red, green, blue):
    # luce 1 davanti a sinistra, 2 dietro a sinistra, 3 dietro a destra, 4 davanti a destra
    # rosso, verde, blu: da 0 a 16 ciascuno
    i2c.write(0x22, bytes([3, light, red, green, blue]))


colors = [(16, 0, 0), (16, 8, 0), (0, 16, 0), (0, 10, 16), (0, 0, 16), (10, 0, 16)]

display.show(Image.HAPPY)

for red, green, blue in colors:
    for light in range(1, 5):
        color(light, red, green, blue)
    delay(500)

for turn in range(12):      # una luce gira in tondo
    for light in range(1, 5):
        color(light, 0, 0, 0)
    color(turn % 4 + 1, 0, 16, 8)
    if turn % 2 == 0:
        setLEDLeft(1)       # spegne anche quella destra
    else:
        setLEDRight(1)
    delay(200)

i2c.write(0x22, bytes([1]))  # tutto spento
