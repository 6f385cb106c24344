# mbrobot_plusV2.py: drive a Maqueen Plus V2 from a micro:bit V2.
# The names, values and bytes on the wire are those of the library schools know from WebTigerPython
# (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on the real robot as well.

from microbit import i2c, pin0, pin1, pin2, pin13, pin14, pin15, sleep
import machine
import music
import neopixel

delay = sleep

# ---- Motors: registers 0 to 3 of the robot's controller at I2C address 0x10 --------------------

_ADDRESS = 0x10
_OFF = "Please connect to Maqueen robot and switch it on."

# Speed in percent -> power byte, one row per ten percent. Motors need power 15 to move at all and gain little above
# 150, so equal steps of speed need growing steps of power.
_POWER = (
    b'\x00\x0f\x10\x10\x11\x12\x12\x13\x13\x14'  # 0 %
    b'\x15\x15\x16\x16\x17\x18\x18\x19\x19\x1a'  # 10 %
    b'\x1b\x1b\x1c\x1c\x1d\x1e\x1e\x1f\x1f\x20'  # 20 %
    b'\x21\x21\x22\x22\x23\x24\x24\x25\x25\x26'  # 30 %
    b'\x27\x29\x2a\x2b\x2c\x2d\x2e\x2f\x30\x31'  # 40 %
    b'\x32\x33\x34\x35\x36\x37\x38\x39\x3a\x3b'  # 50 %
    b'\x3b\x3c\x3e\x3f\x41\x43\x45\x47\x49\x4b'  # 60 %
    b'\x4d\x50\x52\x55\x58\x5b\x5e\x61\x65\x69'  # 70 %
    b'\x6d\x71\x75\x7a\x7f\x84\x89\x8f\x95\x9b'  # 80 %
    b'\xa2\xa9\xb1\xb9\xc1\xca\xd3\xdd\xe8\xf3'  # 90 %
    b'\xff'  # 100 %
)

_speed = 50
_left = 50
_right = 50
_offset = 0
_differential = 0
_arc_scaling = 0

# Register number, then direction and power of the left motor, then of the right motor.
_motors = bytearray(5)


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
    """Adapt to one robot: power added (-14 to 50), left against right (-150 to 150), size of arcs (-50 to 50)."""
    global _offset, _differential, _arc_scaling
    _offset = max(min(int(offset), 50), -14)
    _differential = max(min(int(differential), 150), -150)
    _arc_scaling = max(min(arcScaling, 50), -50)
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
    """Powers of the inner and the outer wheel for a circle of this radius, in metres from the middle of the axle."""
    cm = int(radius * 100)
    outer = max(_speed, 25)
    inner = 0
    if cm > 5:
        scale = 4 * outer - 14 * _arc_scaling - 10 * cm - 490
        inner = int(outer * (3 * _arc_scaling - outer - 9 * cm + 220) / scale) if scale else 0
        inner = min(max(inner, 2 if cm > 15 else 1), 100)
    return _POWER[inner], _POWER[outer]


def leftArc(radius):
    """Drive a circle to the left; radius in metres."""
    inner, outer = _arc(radius)
    _drive(0, inner, 0, outer)


def rightArc(radius):
    """Drive a circle to the right; radius in metres."""
    inner, outer = _arc(radius)
    _drive(0, outer, 0, inner)


class Motor:
    """One motor, turned by itself: 0 is the left one, 2 the right one. The other one keeps its speed."""

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

# ---- Servos: pulses on the pins P0, P1, P2 ---------------------------------------------------------

_duty_at_0 = 25  # of 1023, every 20 ms
_duty_at_180 = 131


def setServo(servo, angle):
    """Turn the servo at port "P0", "P1" or "P2" to an angle from 0 to 180 degrees."""
    if servo in ("P0", "S1"):
        pin = pin0
    elif servo in ("P1", "S2"):
        pin = pin1
    elif servo == "P2":
        pin = pin2
    else:
        raise ValueError("Unknown Servo. Please use 'P0', 'P1' or 'P2'.")
    if not 0 <= angle <= 180:
        raise ValueError("Invalid angle. Must be between 0 and 180")
    way = (_duty_at_180 - _duty_at_0) * int(angle)
    pin.set_analog_period(20)
    # The four shifts make way / 180 of it in whole numbers, rounded down each.
    pin.write_analog(_duty_at_0 + (way >> 8) + (way >> 10) + (way >> 11) + (way >> 12))


def setMinServoDuty(duty):
    """Pulse at 0 degrees as a part of 1023 of 20 ms; 25 at the start."""
    global _duty_at_0
    _duty_at_0 = int(duty)


def setMaxServoDuty(duty):
    """Pulse at 180 degrees as a part of 1023 of 20 ms; 131 at the start."""
    global _duty_at_180
    _duty_at_180 = int(duty)


setMinAngleVal = setMinServoDuty
setMaxAngleVal = setMaxServoDuty

# ---- Sensors --------------------------------------------------------------------------------------

_LINE = b'\x1d'


class IR:
    """Numbers of the line sensors, and their bits in ir_read_values_as_byte()."""

    R2 = 0
    R1 = 1
    M = 2
    L1 = 3
    L2 = 4
    masks = [0x01, 0x02, 0x04, 0x08, 0x10]


class IRSensor:
    """A line sensor below the robot: 0 is R2, 1 R1, 2 M, 3 L1, 4 L2."""

    def __init__(self, index):
        self._index = index

    def read_digital(self):
        """1 on light ground, 0 on dark ground or with nothing below."""
        _send(_LINE)
        return 1 - (i2c.read(_ADDRESS, 1)[0] >> self._index & 1)

    def read_analog(self):
        """Brightness of the ground, 0 to 255."""
        _send(_LINE)
        return i2c.read(_ADDRESS, 11)[1 + 2 * self._index]


irR2 = IRSensor(IR.R2)
irR1 = IRSensor(IR.R1)
irM = IRSensor(IR.M)
irL1 = IRSensor(IR.L1)
irL2 = IRSensor(IR.L2)
irLeft = irL1
irRight = irR1


def ir_read_values_as_byte():
    """All line sensors at once, one bit each: bit 0 is R2, 1 R1, 2 M, 3 L1, 4 L2; 1 on light ground. Negative."""
    i2c.write(_ADDRESS, _LINE)
    return ~i2c.read(_ADDRESS, 1)[0]


def getDistance():
    """Distance to the nearest obstacle in cm, 1 to 500; 255 when there is none."""
    pin13.write_digital(1)
    pin13.write_digital(0)
    echo = machine.time_pulse_us(pin14, 1, 50000)
    cm = (10 * echo + 291) // 582  # 58.2 us per cm, there and back, rounded
    return min(cm, 500) if cm > 0 else 255


# ---- Lights and sound -------------------------------------------------------------------------------


class LEDState:
    """Values for setLED."""

    OFF = 0
    ON = 1
    RED = 1


_leds = bytearray(b'\x0b\x00\x00')


def _light(left_state, right_state):
    _leds[1] = left_state
    _leds[2] = right_state
    i2c.write(_ADDRESS, _leds)


def setLED(state, stateR=None):
    """Red front lights: 1 on, 0 off. One value for both, or one each for left and right."""
    _light(state, state if stateR is None else stateR)


def setLEDLeft(state):
    _light(state, _leds[2])


def setLEDRight(state):
    _light(_leds[1], state)


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
    """Three values, red, green, blue: all four lights. Four values, position, red, green, blue: one light."""
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
