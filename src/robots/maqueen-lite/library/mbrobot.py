# mbrobot.py: drive a Maqueen Lite from a micro:bit V2.
# The names, values and bytes on the wire are those of the library schools know from WebTigerPython
# (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on the real robot as well.

from microbit import i2c, pin1, pin2, pin8, pin12, pin13, pin14, pin15, sleep
import machine
import music
import neopixel

delay = sleep

# ---- Motors: registers 0 to 3 of the robot's controller at I2C address 0x10 --------------------

_ADDRESS = 0x10
_OFF = "Please connect to Maqueen robot and switch it on."

# Speed in percent -> power byte, one row per ten percent. Motors need power 11 to move at all and gain little above
# 150, so equal steps of speed need growing steps of power.
_POWER = (
    b'\x00\x0b\x0b\x0c\x0c\x0d\x0d\x0d\x0e\x0e'  # 0 %
    b'\x0f\x0f\x0f\x10\x10\x11\x11\x11\x12\x12'  # 10 %
    b'\x13\x13\x13\x14\x14\x15\x15\x15\x16\x16'  # 20 %
    b'\x17\x17\x17\x18\x19\x1a\x1b\x1b\x1c\x1d'  # 30 %
    b'\x1e\x1f\x20\x21\x22\x23\x23\x24\x25\x26'  # 40 %
    b'\x27\x28\x29\x2a\x2b\x2b\x2c\x2d\x2e\x2f'  # 50 %
    b'\x30\x31\x32\x33\x34\x36\x38\x3a\x3c\x3f'  # 60 %
    b'\x41\x44\x46\x49\x4c\x4f\x53\x56\x5a\x5e'  # 70 %
    b'\x62\x67\x6b\x70\x75\x7b\x81\x87\x8d\x94'  # 80 %
    b'\x9b\xa3\xab\xb4\xbd\xc6\xd0\xdb\xe6\xf2'  # 90 %
    b'\xff'  # 100 %
)

_speed = 50
_left = 40
_right = 40
_offset = 0
_differential = 0
_arc_scaling = 0

# Register number, then direction and power of the left motor, then of the right motor.
_motors = bytearray(5)
_servo = bytearray(2)


def _send(message):
    try:
        i2c.write(_ADDRESS, message)
    except OSError:
        raise RuntimeError(_OFF)


def _drive(left_direction, left_power, right_direction, right_power):
    _motors[1] = left_direction
    _motors[2] = left_power & 255
    _motors[3] = right_direction
    _motors[4] = right_power & 255
    _send(_motors)


def _power(percent):
    return min(_POWER[percent] + _offset, 255)


def setSpeed(speed):
    """Speed of the following movements in percent, 0 to 100."""
    global _speed, _left, _right
    _speed = int(min(max(speed, 0), 100))
    share = _speed / 100
    gap = abs(_differential)
    slower = _power(_speed) - round(share * gap)
    faster = _power(_speed) + (round((1 - share) * gap) if _speed > 0 else 0)
    if _differential > 0:
        _left, _right = slower, faster
    else:
        _left, _right = faster, slower


def resetSpeed():
    """Back to the usual speed of 50 percent."""
    setSpeed(50)


def calibrate(offset, differential=0, arcScaling=0):
    """Adapt to one robot: power added (-10 to 50), left against right (-150 to 150), size of arcs (-15 to 50)."""
    global _offset, _differential, _arc_scaling
    _offset = max(min(int(offset), 50), -10)
    _differential = max(min(int(differential), 150), -150)
    _arc_scaling = max(min(arcScaling, 50), -15)
    setSpeed(_speed)


def forward():
    _drive(0, _left, 0, _right)


def backward():
    _drive(1, _left, 1, _right)


def left():
    """Turn left on the spot."""
    _drive(1, _left, 0, _right)


def right():
    """Turn right on the spot."""
    _drive(0, _left, 1, _right)


def stop():
    _drive(0, 0, 0, 0)


def _arc(radius):
    """Power of the inner and the outer wheel for a circle, radius in metres."""
    cm = int(radius * 100)
    outer = _speed
    if outer <= max(cm + 20, 40):  # too slow for so wide a circle
        outer = min(max(cm + 40, 40), 100)
    inner = 0
    if cm >= 4:  # below 3.5 cm, half the axle, the inner wheel stands
        scale = cm * (11 + (_arc_scaling - 4) / 10) + 90 + (100 - outer) // 2
        inner = min(int((10 * cm - 35) / scale * outer), 100)
    return _POWER[inner], _POWER[outer]


def leftArc(radius):
    """Circle to the left; radius in metres, from the middle of the axle."""
    inner, outer = _arc(radius)
    _drive(0, inner, 0, outer)


def rightArc(radius):
    """Circle to the right; radius in metres, from the middle of the axle."""
    inner, outer = _arc(radius)
    _drive(0, outer, 0, inner)


class Motor:
    """One motor; the other one keeps its speed."""

    def __init__(self, register):
        self._register = register

    def rotate(self, speed):
        """Turn with a speed in percent, -100 to 100; negative is backward."""
        percent = int(min(abs(speed), 100))
        _motors[1 + self._register] = 0 if speed > 0 else 1
        _motors[2 + self._register] = _power(percent) & 255
        _send(_motors)


motL = Motor(0)
motR = Motor(2)


def setServo(servo, angle):
    """Turn the servo at port "S1" or "S2" to an angle from 0 to 180 degrees."""
    if servo in ("S1", "P0"):
        _servo[0] = 0x14
    elif servo in ("S2", "P1"):
        _servo[0] = 0x15
    else:
        raise ValueError("Unknown Servo. Please use 'S1' or 'S2'.")
    if not 0 <= angle <= 180:
        raise ValueError("Invalid angle. Must be between 0 and 180")
    _servo[1] = angle
    _send(_servo)


# ---- Sensors --------------------------------------------------------------------------------------


class IRSensor:
    """A line sensor below the robot."""

    def __init__(self, pin):
        self._pin = pin

    def read_digital(self):
        """1 on light ground, 0 on dark ground or with nothing below."""
        return self._pin.read_digital()

    def read_analog(self):
        raise NameError("Maqueen Lite does not support reading analog sensor values.")


irLeft = IRSensor(pin13)
irRight = IRSensor(pin14)

pin2.set_pull(pin2.NO_PULL)


def getDistance():
    """Distance to the nearest obstacle in cm, 1 to 500; 255 when there is none."""
    pin1.write_digital(1)
    pin1.write_digital(0)
    echo = machine.time_pulse_us(pin2, 1, 50000)
    cm = (10 * echo + 291) // 582  # 58.2 us per cm, there and back, rounded
    return min(cm, 500) if cm > 0 else 255


# ---- Lights and sound -------------------------------------------------------------------------------


def setLED(state, stateR=None):
    """Red front lights: 1 on, 0 off. One value for both, or one each for left and right."""
    pin8.write_digital(state)
    pin12.write_digital(state if stateR is None else stateR)


def setLEDLeft(state):
    pin8.write_digital(state)


def setLEDRight(state):
    pin12.write_digital(state)


np_rgb_pixels = neopixel.NeoPixel(pin15, 4)


def fillRGB(red, green, blue):
    """All four lights below the robot in one colour, each part 0 to 255."""
    for position in range(4):
        np_rgb_pixels[position] = (red, green, blue)
    np_rgb_pixels.show()


def posRGB(position, red, green, blue):
    """One light below the robot: 0 front left, 1 back left, 2 back right, 3 front right."""
    if not 0 <= position <= 3:
        raise ValueError("invalid RGB-LED position. Must be 0,1,2 or 3.")
    np_rgb_pixels[position] = (red, green, blue)
    np_rgb_pixels.show()


def setRGB(position=None, red=None, green=None, blue=None):
    """Four values, position, red, green, blue: one light. Three values, red, green, blue: all four lights."""
    if position is None:  # called with names
        fillRGB(red, green, blue)
    elif blue is None:
        fillRGB(position, red, green)
    else:
        posRGB(position, red, green, blue)


def clearRGB():
    np_rgb_pixels.clear()


def setAlarm(state):
    """Two tones again and again in the background: 1 on, 0 off."""
    if state:
        music.play(["c5:1", "r", "c5:1", "r:3"], wait=False, loop=True)
    else:
        music.stop()


def beep():
    music.pitch(440, 200, wait=False)


# ---- What TigerJython's own simulation can be told; on the board it is only printed -----------------


def _tell(name, *values):
    print(name + "(" + ",".join([str(value) for value in values]) + ")")


class RobotContext:
    """Settings of TigerJython's simulation."""

    @staticmethod
    def enableTrace(value):
        _tell("RobotContext.enableTrace", value)

    @staticmethod
    def enableRotCenter(value):
        _tell("RobotContext.enableRotCenter", value)

    @staticmethod
    def setStartPosition(x, y):
        _tell("RobotContext.setStartPosition", x, y)

    @staticmethod
    def setStartDirection(angle):
        _tell("RobotContext.setStartDirection", angle)

    @staticmethod
    def useBackground(sprite):
        _tell("RobotContext.useBackground", sprite)

    @staticmethod
    def useObstacle(sprite, x=None, y=None):
        if x is None or y is None:
            _tell("RobotContext.useObstacle", sprite)
        else:
            _tell("RobotContext.useObstacle", sprite, x, y)


def setBeamAreaColor(color):
    _tell("setBeamAreaColor", color)


def setProximityCircleColor(color):
    _tell("setProximityCircleColor", color)


def setMeshTriangleColor(color):
    _tell("setMeshTriangleColor", color)


def eraseBeamArea():
    _tell("eraseBeamArea")
