# simrobot.py: programs that were written for TigerJython's simulated Lego robots, on the robot that is plugged in.
# The names are those of TigerJython (Tiger-Jython/Aplu-Libraries); the code is our own and drives the robot through its
# own library. Runs on real robots as well: put that library and this file on the board.
#
# A Lego brick has other keys and other sensors than these robots:
#   ENTER and LEFT are button A, ESCAPE and RIGHT are button B
#   light sensor S1 is the right line sensor, S2 the left one, S3 the one in the middle, or else the right one
#   touch sensor S1 is the right half of the bumper, S2 the left one, S3 both; only the Calli:bot has one
#   motor A is the left one, B the right one

from microbit import button_a, button_b, i2c, sleep
import music
import os

delay = sleep

# ---- Which robot it is -------------------------------------------------------------------------


def _version():
    """The end of the version text of a Maqueen: 4.0, 1.4, 2.0, 2.1."""
    i2c.write(0x10, b"\x32")
    length = i2c.read(0x10, 1)[0]
    i2c.write(0x10, b"\x33")
    return bytes(i2c.read(0x10, length))[-3:]


def _library():
    """The library of the robot that answers on the bus."""
    addresses = i2c.scan()
    if 0x21 in addresses:
        import callibot as library
    elif 0x10 not in addresses:
        raise RuntimeError("Please connect to a robot and switch it on.")
    elif "Calliope" in os.uname().machine:  # there it is a MotionKit 2; its version text is not published
        import callimk as library
    elif _version() in (b"2.0", b"2.1"):
        import mbrobot_plusV2 as library
    elif _version() == b"1.4":
        import mbrobot_plus as library
    else:
        import mbrobot as library
    return library


_robot = _library()
_speed = 50
_moving = False

# ---- Driving ------------------------------------------------------------------------------------


def _drive(move, ms, *radius):
    """Begin a movement; with a time, wait and stop after it."""
    global _moving
    move(*radius)
    _moving = True
    if ms is not None:
        sleep(ms)
        stop()


def forward(ms=None):
    _drive(_robot.forward, ms)


def backward(ms=None):
    _drive(_robot.backward, ms)


def left(ms=None):
    """Turn left on the spot."""
    _drive(_robot.left, ms)


def right(ms=None):
    """Turn right on the spot."""
    _drive(_robot.right, ms)


def leftArc(radius, ms=None):
    """Circle to the left; radius in metres."""
    _drive(_robot.leftArc, ms, radius)


def rightArc(radius, ms=None):
    """Circle to the right; radius in metres."""
    _drive(_robot.rightArc, ms, radius)


def stop():
    global _moving
    _robot.stop()
    _moving = False


def setSpeed(speed):
    """Speed of the following movements, 0 to 100."""
    global _speed
    _speed = speed
    _robot.setSpeed(speed)


def isMoving():
    return _moving


class Gear:
    """Both motors together."""

    def forward(self, ms=None):
        forward(ms)

    def backward(self, ms=None):
        backward(ms)

    def left(self, ms=None):
        left(ms)

    def right(self, ms=None):
        right(ms)

    def leftArc(self, radius, ms=None):
        leftArc(radius, ms)

    def rightArc(self, radius, ms=None):
        rightArc(radius, ms)

    def stop(self):
        stop()

    def setSpeed(self, speed):
        setSpeed(speed)

    def getSpeed(self):
        return _speed

    def isMoving(self):
        return _moving


class MotorPort:
    A = 0
    B = 1


class Motor:
    """One motor: MotorPort.A is the left one, MotorPort.B the right one."""

    def __init__(self, port):
        self._port = port
        self._speed = 50

    def rotate(self, speed):
        """Turn with a speed of -100 to 100; negative is backward."""
        library = _robot
        if hasattr(library, "motorL"):
            (library.motorR if self._port else library.motorL)(int(speed < 0), abs(speed))
            return
        if not hasattr(library, "motL"):
            import callibotmot as library
        (library.motR if self._port else library.motL).rotate(speed)

    def setSpeed(self, speed):
        self._speed = speed

    def forward(self):
        self.rotate(self._speed)

    def backward(self):
        self.rotate(-self._speed)

    def stop(self):
        self.rotate(0)


# ---- Sensors -------------------------------------------------------------------------------------


class SensorPort:
    S1 = 0
    S2 = 1
    S3 = 2
    S4 = 3


class LightSensor:
    """A line sensor."""

    def __init__(self, port):
        self._left = port == SensorPort.S2
        self._middle = port == SensorPort.S3 and hasattr(_robot, "irM")

    def activate(self, on):
        """The sensor is always on."""

    def getValue(self):
        """0 on black to 1000 on white ground; robots that know only light and dark give one of the two."""
        if hasattr(_robot, "irLeftValue"):
            return 1000 * (_robot.irLeftValue() if self._left else _robot.irRightValue())
        sensor = _robot.irM if self._middle else _robot.irLeft if self._left else _robot.irRight
        if hasattr(_robot, "irM"):
            return sensor.read_analog() * 1000 // 255
        return 1000 * sensor.read_digital()


class UltrasonicSensor:
    """The ultrasonic sensor."""

    def __init__(self, port=0):
        pass

    def getDistance(self):
        """Distance to the nearest obstacle in cm; -1 when there is none."""
        cm = int(_robot.getDistance())
        return cm if 0 < cm < 255 else -1


class TouchSensor:
    """The bumper of a Calli:bot."""

    def __init__(self, port):
        self._bits = (0x04, 0x08)[port] if port in (SensorPort.S1, SensorPort.S2) else 0x0C

    def isPressed(self):
        if not hasattr(_robot, "tsValue"):
            raise RuntimeError("This robot has no touch sensor.")
        return i2c.read(0x21, 1)[0] & self._bits != 0


def getDistance():
    """Distance to the nearest obstacle in cm; -1 when there is none."""
    return us1.getDistance()


motA = motL = Motor(MotorPort.A)
motB = motR = Motor(MotorPort.B)
us1 = UltrasonicSensor()
ls1 = LightSensor(SensorPort.S1)
ls2 = LightSensor(SensorPort.S2)
ls3 = LightSensor(SensorPort.S3)
ts1 = TouchSensor(SensorPort.S1)
ts2 = TouchSensor(SensorPort.S2)
ts3 = TouchSensor(SensorPort.S3)

# ---- The brick -----------------------------------------------------------------------------------


def isEnterHit():
    """Button A was pressed."""
    return button_a.was_pressed()


def isEscapeHit():
    """Button B was pressed."""
    return button_b.was_pressed()


isLeftHit = isEnterHit
isRightHit = isEscapeHit


def playTone(frequency, ms):
    """A tone of so many hertz."""
    music.pitch(frequency, ms)


def setLED(pattern):
    """The red lights: 0 off, any other number on."""
    _robot.setLED(1 if pattern else 0)


def exit():
    """Stop; the program goes on."""
    stop()


class LegoRobot:
    """The robot."""

    def addPart(self, part):
        """Every part is there already."""

    def isEnterHit(self):
        return isEnterHit()

    def isEscapeHit(self):
        return isEscapeHit()

    def isLeftHit(self):
        return isLeftHit()

    def isRightHit(self):
        return isRightHit()

    def isRunning(self):
        return True

    def playTone(self, frequency, ms):
        playTone(frequency, ms)

    def setLED(self, pattern):
        setLED(pattern)

    def exit(self):
        exit()


NxtRobot = LegoRobot


class Tools:
    @staticmethod
    def delay(ms):
        sleep(ms)


# ---- What TigerJython's own simulation can be told; here it is only printed ---------------------


def _tell(name, *values):
    print(name + "(" + ",".join([str(value) for value in values]) + ")")


class RobotContext:
    @staticmethod
    def setStartPosition(x, y):
        _tell("RobotContext.setStartPosition", x, y)

    @staticmethod
    def setStartDirection(angle):
        _tell("RobotContext.setStartDirection", angle)

    @staticmethod
    def useBackground(*arguments):
        _tell("RobotContext.useBackground", *arguments)

    @staticmethod
    def useObstacle(*arguments):
        _tell("RobotContext.useObstacle", *arguments)

    @staticmethod
    def useTarget(*arguments):
        _tell("RobotContext.useTarget", *arguments)

    @staticmethod
    def enableTrace(on):
        _tell("RobotContext.enableTrace", on)

    @staticmethod
    def enableRotCenter(on):
        _tell("RobotContext.enableRotCenter", on)

    @staticmethod
    def showNavigationBar(*arguments):
        _tell("RobotContext.showNavigationBar", *arguments)

    @staticmethod
    def showStatusBar(height):
        _tell("RobotContext.showStatusBar", height)

    @staticmethod
    def setStatusText(text):
        _tell("RobotContext.setStatusText", text)
