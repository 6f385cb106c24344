# mbrobotmot.py: the two motors of a Maqueen Lite, one by one.
# Names, values and bytes on the wire are those of the older school library of that name (Tiger-Jython, version 1.2):
# speeds are power bytes here, not percent. The code is our own. Runs on the real robot as well.

from microbit import i2c, pin1, pin2, pin8, pin12, pin13, pin14, sleep
import machine

delay = sleep
irLeft = pin13
irRight = pin14
ledLeft = pin8
ledRight = pin12

pin2.set_pull(pin2.NO_PULL)


class Motor:
    """One motor: number 0 is the left one, 1 the right one."""

    def __init__(self, number):
        self._message = bytearray((2 * number, 0, 0))

    def rotate(self, speed):
        """Turn with a power of -255 to 255; negative is backward, 0 stops."""
        self._message[1] = 1 if speed < 0 else 0
        self._message[2] = abs(speed) & 255
        try:
            i2c.write(0x10, self._message)
        except OSError:
            print("Please switch on mbRobot!")
            while True:
                pass


motL = Motor(0)
motR = Motor(1)


def getDistance():
    """Distance to the nearest obstacle in cm; 255 when there is none."""
    pin1.write_digital(1)
    pin1.write_digital(0)
    echo = machine.time_pulse_us(pin2, 1, 50000)
    cm = int(echo / 58.2 + 0.5)  # 58.2 us per cm, there and back
    return cm if cm > 0 else 255


def setLED(on):
    """Both red front lights: 1 on, 0 off."""
    pin8.write_digital(on)
    pin12.write_digital(on)
