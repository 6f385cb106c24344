# mbrobot_plus.py: drive a Maqueen Plus V1 from a micro:bit V2.
# The names, values and bytes on the wire are those of the library schools know from TigerJython and WebTigerPython
# (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on the real robot as well.

from microbit import i2c, pin1, pin2, sleep
import machine
import music

delay = sleep

# ---- Motors: registers of the robot's controller at I2C address 0x10 ----------------------------

_ADDRESS = 0x10
_OFF = "Please switch on mbRobot!"
_AXLE = 0.082  # metres; belongs to the formula of arcs

_FORWARD = 1
_BACKWARD = 2

_speed = 50


def _write(*message):
    i2c.write(_ADDRESS, bytearray(message))


def _drive(left_direction, left_power, right_direction, right_power):
    try:
        _write(0x00, left_direction, left_power, right_direction, right_power)
    except OSError:
        print(_OFF)


def setPID(on):
    """1: the robot keeps its speed by itself, 0: it does not."""
    _write(0x0A, on)


def setSpeed(speed):
    """Speed of the following movements, 0 to 255. Below 30 the robot keeps it by itself."""
    global _speed
    setPID(1 if speed < 30 and speed != 0 else 0)
    if speed < 30 and speed != 0:
        speed += 30
    elif 30 <= speed < 32:
        speed += 2
    _speed = speed


def resetSpeed():
    """Back to the usual speed of 50."""
    global _speed
    setPID(0)
    _speed = 50


def stop():
    setPID(0)
    _drive(0, 0, 0, 0)


def forward():
    _drive(_FORWARD, _speed, _FORWARD, _speed)


def backward():
    _drive(_BACKWARD, _speed, _BACKWARD, _speed)


def _turning():
    """Power for a turn on the spot: fast robots turn a little slower, slow ones a little faster."""
    return int(_speed * (1.825 - 0.0175 * _speed))


def left():
    """Turn left on the spot."""
    power = _turning()
    _drive(_BACKWARD, power, _FORWARD, power)


def right():
    """Turn right on the spot."""
    power = _turning()
    _drive(_FORWARD, power, _BACKWARD, power)


def _inner(radius):
    """Power of the inner wheel for a circle, radius in metres."""
    outer = abs(_speed)
    if radius < _AXLE:
        return 0
    return int((radius - _AXLE) / (radius + _AXLE) * (1 - outer * outer / 200000) * outer)


def leftArc(radius):
    """Circle to the left; radius in metres, from the middle of the axle."""
    inner, outer = _inner(radius), abs(_speed)
    if _speed > 0:
        _drive(_FORWARD, inner, _FORWARD, outer)
    else:
        _drive(_BACKWARD, outer, _BACKWARD, inner)


def rightArc(radius):
    """Circle to the right; radius in metres, from the middle of the axle."""
    inner, outer = _inner(radius), abs(_speed)
    if _speed > 0:
        _drive(_FORWARD, outer, _FORWARD, inner)
    else:
        _drive(_BACKWARD, inner, _BACKWARD, outer)


class Motor:
    """One motor: 0 is the left one, 1 the right one."""

    def __init__(self, id):
        self._register = 2 * id

    def rotate(self, speed):
        """Turn with a power of -255 to 255; negative is backward, 0 stops."""
        direction = 0 if speed == 0 else _FORWARD if speed > 0 else _BACKWARD
        try:
            _write(self._register, direction, abs(speed))
        except OSError:
            print(_OFF)
            while True:
                pass


motL = Motor(0)
motR = Motor(1)


def setServo(servo, angle):
    """Turn the servo at port "S1", "S2" or "S3" to an angle from 0 to 180 degrees."""
    if servo not in ("S1", "S2", "S3"):
        raise ValueError("Unknown Servo. Please use 'S1', 'S2' or 'S3'.")
    _write(0x13 + int(servo[1]), angle)


# ---- Sensors ---------------------------------------------------------------------------------------


class IR:
    """Numbers of the line sensors, from left to right."""

    L3 = 0
    L2 = 1
    L1 = 2
    R1 = 3
    R2 = 4
    R3 = 5
    masks = [1, 2, 4, 8, 16, 32]


def ir_read_values_as_byte():
    """All line sensors at once: bit 0 is L3, bit 5 is R3, 1 on light ground. The bits above are 1."""
    _write(0x1D)
    return ~i2c.read(_ADDRESS, 1)[0]


class IRSensor:
    """A line sensor below the robot."""

    def __init__(self, index):
        self.index = index

    def read_digital(self):
        """1 on light ground, 0 on dark ground."""
        return ir_read_values_as_byte() >> self.index & 1


irL3 = IRSensor(IR.L3)
irL2 = IRSensor(IR.L2)
irL1 = IRSensor(IR.L1)
irR1 = IRSensor(IR.R1)
irR2 = IRSensor(IR.R2)
irR3 = IRSensor(IR.R3)
irLeft = irL1
irRight = irR1

pin2.set_pull(pin2.NO_PULL)


def getDistance():
    """Distance to the nearest obstacle in cm; 255 when there is none."""
    pin1.write_digital(1)
    pin1.write_digital(0)
    cm = int(machine.time_pulse_us(pin2, 1, 50000) / 58.2 - 0.5)
    return cm if cm > 0 else 255


# ---- Lights and sound --------------------------------------------------------------------------------


class LEDState:
    """Colours of the front lights."""

    OFF = 0
    RED = 1
    GREEN = 2
    YELLOW = 3
    BLUE = 4
    PINK = 5
    CYAN = 6
    WHITE = 7


def setLED(state, stateR=None):
    """Colour of the front lights, 0 to 7: one for both, or one each. 0 for the right one means the same as left."""
    _write(0x0B, state, stateR or state)


def setLEDLeft(state):
    _write(0x0B, state)


def setLEDRight(state):
    _write(0x0C, state)


def setAlarm(on):
    """A tone again and again in the background: 1 on, 0 off."""
    if on:
        music.play(["c6:1", "r", "c6:1", "r:3"], wait=False, loop=True)
    else:
        music.stop()


def beep():
    music.pitch(2000, 200, wait=False)


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
