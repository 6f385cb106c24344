# Slalom
# Um jeden Pfosten ein Halbkreis: einmal nach rechts, einmal nach links.
from mbrobot import *

HALF_CIRCLE = 3825      # Millisekunden für 180 Grad mit setSpeed(50)

def half_circle(arc):
    arc(0.2)            # rightArc oder leftArc, Radius in Metern
    delay(HALF_CIRCLE)
    stop()
    delay(300)          # jeder Halbkreis beginnt im Stand

setSpeed(50)

for i in range(2):
    half_circle(rightArc)
    half_circle(leftArc)
fillRGB(0, 80, 0)       # geschafft!
