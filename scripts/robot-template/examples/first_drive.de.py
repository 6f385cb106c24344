# Erste Fahrt
# Ein kurzer Weg und eine Drehung. Verändere die Zahlen und schau, was passiert!
from microbit import sleep
from new_robot import *

setLED(1)
forward()
sleep(1000)
left()
sleep(400)
stop()
setLED(0)
print("hell" if isLight() else "dunkel")
