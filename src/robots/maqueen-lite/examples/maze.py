# Durch das Labyrinth
from mbrobot import *

setSpeed(40)
forward()
