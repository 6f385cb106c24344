# Erste Fahrt
# Ein Stück geradeaus, ein Kreis, eine Drehung.
# Verändere die Zahlen und schau, was passiert!
from callibot import *

setSpeed(50)
setLED(1)
forward()
delay(1000)             # 1000 Millisekunden sind eine Sekunde

rightArc(0.15)          # ein Kreis mit 15 cm Radius
delay(4000)

left()                  # dreht sich an Ort
delay(600)

stop()
setLED(0)
print("Abstand nach vorn:", round(getDistance()), "cm")
