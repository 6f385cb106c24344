# Slalom
# Task: drive around the posts to the target without touching them.
# rightArc(0.2) drives an arc to the right with a radius of 20 cm. How long does a half circle take?
from mbrobot import *

setSpeed(50)

rightArc(0.2)
delay(2000)             # milliseconds: not yet enough
stop()
# And how does it go around the next post?
