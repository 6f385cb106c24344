# Logging data
# A row twice a second. Open the data log and change the sensors.
from microbit import *
import log

log.set_labels('light', 'temperature', timestamp=log.SECONDS)

for row in range(60):
    log.add(light=display.read_light_level(), temperature=temperature())
    display.set_pixel(row % 5, row // 5 % 5, row % 9 + 1)
    sleep(500)

display.show(Image.YES)       # done: the table can be saved
