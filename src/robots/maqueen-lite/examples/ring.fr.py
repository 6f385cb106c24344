# Anneau de LED
# À la broche 2 est branché un anneau de 24 LED :
# un arc-en-ciel tourne pendant que le robot roule en cercle.
from mbrobot import *
from mbled import *

# trois couleurs, avec huit pas de l'une à l'autre
for pos in range(8):
    percent = pos * 100 / 8
    set_led(pos, *lerp_RGB(60, 0, 0, 0, 60, 0, percent))         # du rouge au vert
    set_led(pos + 8, *lerp_RGB(0, 60, 0, 0, 0, 60, percent))     # du vert au bleu
    set_led(pos + 16, *lerp_RGB(0, 0, 60, 60, 0, 0, percent))    # du bleu au rouge

setSpeed(40)
leftArc(0.2)
for step in range(96):      # 24 pas font un tour
    shift_by(1)
    delay(80)
stop()
clear()
