# callibotmot.py: the two motors of a Calli:bot, one by one.
# Names, values and bytes on the wire are those of the school library of that name (Tiger-Jython/Robotics-Libraries,
# version 1.0); the code is our own. Runs on the real robot as well.

from calliope_mini import i2c, sleep

delay = sleep


class Motor:
    """One motor: number 0 is the left one, any other the right one."""

    def __init__(self, number):
        self._register = 2 if number else 0

    def rotate(self, speed):
        """Turn with this speed, -200 to 200; the power is 50 more. Negative is backward, 0 stops."""
        power = abs(speed) + 50 if speed else 0
        try:
            i2c.write(0x20, bytearray((self._register, int(speed < 0), power)))
        except OSError:
            print("Please switch on mbRobot!")
            while True:
                sleep(100)


motL = Motor(0)
motR = Motor(2)


def setLED(on):
    """Both red lights: 1 on, 0 off."""
    i2c.write(0x21, bytearray((0, 3 if on == 1 else 0)))
