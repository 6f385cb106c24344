# Anello di LED
# Al pin 2 è collegato un anello di 24 LED:
# un arcobaleno gira mentre il robot va in cerchio.
from mbrobot import *
from mbled import *

# tre colori, con otto passi dall'uno all'altro
for pos in range(8):
    percent = pos * 100 / 8
    set_led(pos, *lerp_RGB(60, 0, 0, 0, 60, 0, percent))         # dal rosso al verde
    set_led(pos + 8, *lerp_RGB(0, 60, 0, 0, 0, 60, percent))     # dal verde al blu
    set_led(pos + 16, *lerp_RGB(0, 0, 60, 60, 0, 0, percent))    # dal blu al rosso

setSpeed(40)
leftArc(0.2)
for step in range(96):      # 24 passi sono un giro
    shift_by(1)
    delay(80)
stop()
clear()
