# Ein Servo am Anschluss S1
# Daran hängt ein Greifer: 30 heisst offen, 90 heisst zu.
# Für Servos gibt es in callibot keinen Befehl:
# Das Programm schickt die Bytes selbst.
from callibot import *

OPEN = 30
CLOSED = 90


def set_servo(angle):
    # 0x14 ist S1, 0x15 ist S2; der Winkel geht von 0 bis 180
    i2c.write(0x20, bytes([0x14, angle]))


for turn in range(3):
    set_servo(OPEN)
    delay(1000)
    set_servo(CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # langsam öffnen
    set_servo(angle)
    delay(100)
