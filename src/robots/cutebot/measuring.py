from cutebot import set_motors_speed, stop
from cutebot import get_sonar_distance as getDistance

delay = sleep
_speed = 50


def setSpeed(percent):
    global _speed
    _speed = percent


def forward():
    set_motors_speed(_speed, _speed)


def left():
    set_motors_speed(-_speed, _speed)
