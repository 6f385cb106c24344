# Tenere la distanza
# Il robot va fino a 10 cm dal muro e ricorda quanto tempo ci ha messo.
# All'indietro ci vuole lo stesso tempo.
from microbit import running_time
from mbrobot import *

setSpeed(50)

start = running_time()
forward()
while getDistance() > 10:
    delay(10)
stop()
way = running_time() - start

beep()
print("Tempo di marcia:", way, "ms")
delay(500)

backward()
delay(way)
stop()
