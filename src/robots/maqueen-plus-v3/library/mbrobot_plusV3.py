# mbrobot_plusV3.py: drive a Maqueen Plus V3 with its lidar from a micro:bit V2.
# The names, values and bytes on the wire are those of the library schools know from WebTigerPython
# (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on the real robot as well.

from microbit import i2c, pin0, pin1, pin2, running_time, sleep
import music
import neopixel

delay = sleep

_ROBOT = 0x10
_LIDAR = 0x33
_OFF = "Please connect to Maqueen robot and switch it on."


def _set(register, value):
    i2c.write(_ROBOT, bytes((register, value & 255)))


def _get(register, count=1):
    i2c.write(_ROBOT, bytes((register,)))
    return i2c.read(_ROBOT, count)


# ---- Motors: registers 0 to 3 ----------------------------------------------------------------------

# Speed in percent -> power byte for arcs, one row per ten percent: those of the Plus V2.
_ARC_POWER = (
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

_percent = 50
_power = 50  # until the first setSpeed()

# Register number, then direction and power of the left motor, then of the right motor.
_motors = bytearray(5)


def _drive(left_direction, left_power, right_direction, right_power):
    _motors[1] = left_direction
    _motors[2] = left_power & 255
    _motors[3] = right_direction
    _motors[4] = right_power & 255
    _send_motors()


def _send_motors():
    try:
        i2c.write(_ROBOT, _motors)
    except OSError:
        raise RuntimeError(_OFF)


def setSpeed(speed):
    """Speed of the following movements in percent, 0 to 100."""
    global _percent, _power
    _percent = int(min(max(speed, 0), 100))
    _power = round(2.4 * speed + 14)


def resetSpeed():
    """Back to the usual speed of 50 percent."""
    setSpeed(50)


def forward():
    _drive(0, _power, 0, _power)


def backward():
    _drive(1, _power, 1, _power)


def left():
    """Turn left on the spot."""
    _drive(1, _power, 0, _power)


def right():
    """Turn right on the spot."""
    _drive(0, _power, 1, _power)


def stop():
    _drive(0, 0, 0, 0)


def _arc(radius):
    """Powers of the inner and the outer wheel for a circle of this radius, in metres from the middle of the axle."""
    cm = int(radius * 100)
    outer = max(_percent, 25)
    inner = 0
    if cm > 5:
        inner = int(outer * (220 - outer - 9 * cm) / (4 * outer - 490 - 10 * cm))
        if inner < 2:
            inner = 2 if cm > 15 else 1
    return _ARC_POWER[inner], _ARC_POWER[outer]


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
        """Turn with a power of -100 to 100 (of 255); negative is backward."""
        _motors[1 + self._register] = 0 if speed > 0 else 1
        _motors[2 + self._register] = int(min(abs(speed), 100))
        _send_motors()


motL = Motor(0)
motR = Motor(2)

# ---- Measured moves: the robot drives a distance or turns by an angle by itself -----------------------

_GRADE = 2


def _go(wait):
    _set(60, 6)
    if wait == 1:
        busy = _get(87)
        while busy[0] == 1:
            sleep(10)
            busy = i2c.read(_ROBOT, 1)


def pidControlDistance(dir, distance, interruption):
    """Drive a distance in whole cm: dir 1 forward, 2 backward; interruption 1 waits until it is done."""
    if distance >= 6000:
        distance = 60000
    _set(64, dir)
    _set(85, _GRADE)
    _set(65, distance >> 8)
    _set(66, distance)
    _go(interruption)


def pidControlAngle(angle, interruption):
    """Turn on the spot by whole degrees, up to 255: positive right, negative left; interruption 1 waits."""
    _set(67, 1 if angle >= 0 else 2)
    _set(86, _GRADE)
    _set(68, abs(angle))
    _go(interruption)


def pidControlStop():
    """Break off a measured move."""
    _set(60, 16)


def readRealTimeSpeed(type):
    """Speed of a wheel in cm/s, without a sign: 1 is the left one, any other number the right one."""
    _set(76, 1)
    speeds = i2c.read(_ROBOT, 2)
    return speeds[0 if type == 1 else 1] / 5


# ---- Line patrol: the robot follows a line by itself ----------------------------------------------------


def setPatrolSpeed(speed):
    """Speed of the patrol, 1 to 5."""
    _set(63, speed)


def patrolling(patrol):
    """1 starts following the line, any other number ends it."""
    _set(60, 5 if patrol == 1 else 8)


def setIntersectionRunMode(mode):
    """At a crossing: 1 left, 2 right, 3 straight on, 4 stop."""
    _set(69, mode)


def setTRordRunMode(mode):
    """Where the line ends at another one across: 1 left, 2 right, 4 stop."""
    _set(70, mode)


def setLeftOrStraightRunMode(mode):
    """At a branch to the left: 1 left, 3 straight on, 4 stop."""
    _set(71, mode)


def setRightOrStraightRunMode(mode):
    """At a branch to the right: 2 right, 3 straight on, 4 stop."""
    _set(72, mode)


def intersectionDetecting():
    """The junction under the robot: 0 none, 1 crossing, 2 T, 3 left or straight on, 4 right or straight on."""
    return _get(61)[0]


# ---- Servos: pulses on the pins P0, P1, P2 --------------------------------------------------------------


def setServo(servo, angle):
    """Turn the servo at port "S1" (or "P0"), "S2" ("P1") or "S3" ("P2") to an angle from 0 to 180 degrees."""
    if not 0 <= angle <= 180:
        raise ValueError("Invalid angle. Must be between 0 and 180")
    if servo in ("P0", "S1"):
        pin = pin0
    elif servo in ("P1", "S2"):
        pin = pin1
    elif servo in ("P2", "S3"):
        pin = pin2
    else:
        raise ValueError("Valid servo names: S1, S2, S3 or P0, P1, P2")
    way = 106 * int(angle)
    pin.set_analog_period(20)
    # 25 to 131 of 1023; the four shifts make way / 180 in whole numbers, rounded down each.
    pin.write_analog(25 + (way >> 8) + (way >> 10) + (way >> 11) + (way >> 12))


# ---- Line and light sensors -----------------------------------------------------------------------------


def _line(count):
    try:
        return _get(29, count)
    except OSError:
        raise RuntimeError(_OFF)


class IRSensor:
    """A line sensor below the robot: 0 is R2, 1 R1, 2 M, 3 L1, 4 L2."""

    def __init__(self, index):
        self.index = index

    def read_digital(self):
        """1 on light ground, 0 on dark ground or with nothing below."""
        return 1 - (_line(1)[0] >> self.index & 1)

    def read_analog(self):
        """Brightness of the ground, 0 to 4095."""
        values = _line(11)
        return values[2 + 2 * self.index] << 8 | values[1 + 2 * self.index]


irR2 = IRSensor(0)
irR1 = IRSensor(1)
irM = IRSensor(2)
irL1 = IRSensor(3)
irL2 = IRSensor(4)
irLeft = irL1
irRight = irR1


def readLightIntensity(side):
    """Brightness around the robot, 0 to 1023: 1 is the left sensor, any other number the right one."""
    values = _get(78, 4)
    at = 0 if side == 1 else 2
    return values[at] << 8 | values[at + 1]


# ---- Lidar: 8 x 8 or 4 x 4 cells, column 0 on the left, row 0 at the top ----------------------------------

_MODE_TEXT = "Switching Lidar Mode to {0}x{0}.\nPlease wait up to 10 seconds."

_cells = 8  # per row


def _tell_lidar(request):
    # It starts 3 s after the robot is switched on; a program that asks sooner waits for it.
    while True:
        try:
            return i2c.write(_LIDAR, request)
        except OSError:
            if running_time() > 4000:
                raise
            sleep(50)


def _ask_lidar(command, arguments=b''):
    """Data of the lidar's reply, or None if it does not reply within a second or cannot do it."""
    _tell_lidar(bytes((0x55, 0, len(arguments) + 1, command)) + arguments)
    until = running_time() + 1000
    status = 0xff
    while status == 0xff:
        if running_time() >= until:
            return None
        status = i2c.read(_LIDAR, 1)[0]
        if status == 0x63:
            return None
        sleep(16)
    head = i2c.read(_LIDAR, 3)
    if status != 0x53 or head[0] != command:
        return None
    rest = head[1] | head[2] << 8
    data = b''
    while rest > 0:
        piece = i2c.read(_LIDAR, min(rest, 32))
        data += piece
        rest -= len(piece)
    return data


def _in_cm(data):
    """The words of a reply in cm; an empty list without a reply."""
    return [(data[i] | data[i + 1] << 8) // 10 for i in range(0, len(data or b''), 2)]


def setLidarMode(mode=8):
    """Choose 8 x 8 or 4 x 4 cells; takes five seconds."""
    global _cells
    if mode not in (4, 8):
        raise ValueError("Lidar mode must be 4 or 8")
    print(_MODE_TEXT.format(mode))
    for _ in range(10):
        if _ask_lidar(1, bytes((0, 0, 0, mode))) is not None:
            _cells = mode
            sleep(5000)
            return
        sleep(17)
    raise RuntimeError("Failed to switch Lidar Mode")


def getDistanceAt(x_pos, y_pos):
    """Distance in cm in one cell, column and row counted from the upper left; 400 for nothing, 1023 for no answer."""
    distances = _in_cm(_ask_lidar(3, bytes((x_pos, y_pos))))
    return distances[0] if distances else 1023


def getDistance():
    """Distance in cm straight ahead: the least of the four cells in the middle."""
    after = _cells // 2
    before = after - 1
    return min([getDistanceAt(x, y) for y in (before, after) for x in (before, after)])


def getDistanceList():
    """Distances in cm in all cells, row by row from the upper left; an empty list for no answer."""
    return _in_cm(_ask_lidar(2))


def getDistanceGrid():
    """The same as a list of rows."""
    distances = getDistanceList()
    width = 8 if len(distances) == 64 else 4
    return [distances[i:i + width] for i in range(0, len(distances), width)]


def getDistanceColumn(index):
    """Distances in cm in one column, from the top down."""
    return _in_cm(_ask_lidar(5, bytes((index,))))


def getDistanceRow(index):
    """Distances in cm in one row, from left to right."""
    return _in_cm(_ask_lidar(6, bytes((index,))))


# ---- Lights and sound -------------------------------------------------------------------------------------


def setLEDs(rgbl, rgbr):
    """Colours of both lamps: 0 off, 1 red, 2 green, 3 yellow, 4 blue, 5 pink, 6 cyan, 7 white."""
    setLEDLeft(rgbl)
    setLEDRight(rgbr)


def setLED(rgb):
    """One colour for both lamps."""
    setLEDs(rgb, rgb)


def setLEDLeft(rgbl):
    _set(11, rgbl)


def setLEDRight(rgbr):
    _set(12, rgbr)


_pixels = neopixel.NeoPixel(pin1, 4)


def fillRGB(red, green, blue):
    """All four lights below the robot in one colour, each part 0 to 255."""
    for position in range(4):
        _pixels[position] = (red, green, blue)
    _pixels.show()


def setRGB(r, g, b):
    """The same as fillRGB."""
    fillRGB(r, g, b)


def posRGB(position, red, green, blue):
    """One light below the robot: 0 front left, 1 back left, 2 back right, 3 front right."""
    if not 0 <= position <= 3:
        raise ValueError("invalid RGB-LED position. Must be 0,1,2 or 3.")
    _pixels[position] = (red, green, blue)
    _pixels.show()


def clearRGB():
    _pixels.clear()


def setAlarm(state):
    """Tones again and again in the background: 1 on, 0 off."""
    if state:
        # The comma of the third note is the original's; that note keeps the length of the one before.
        music.play(["c5:1", "r", "c5,1", "r:3"], wait=False, loop=True)
    else:
        music.stop()


def beep():
    music.pitch(440, 200, wait=False)


# ---- What TigerJython's own simulation can be told; on the board it is only printed -------------------------


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


pin2.set_pull(pin2.NO_PULL)
