# new_robot.py: drive a New Robot from a micro:bit V2.

from microbit import i2c, pin8, pin13

_ADDRESS = 0x10


def motors(left, right):
    """Turn both wheels: -255 to 255, negative is backward."""
    message = [0]
    for speed in (left, right):
        message.append(1 if speed < 0 else 0)
        message.append(min(abs(speed), 255))
    i2c.write(_ADDRESS, bytes(message))


def forward():
    motors(100, 100)


def left():
    """Turn left on the spot."""
    motors(-100, 100)


def right():
    """Turn right on the spot."""
    motors(100, -100)


def stop():
    motors(0, 0)


def setLED(on):
    """Red light: 1 on, 0 off."""
    pin8.write_digital(on)


def isLight():
    """The ground below the line sensor: 1 light, 0 dark."""
    return pin13.read_digital()
