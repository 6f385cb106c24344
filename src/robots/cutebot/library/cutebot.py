# cutebot.py: drive an Elecfreaks Cutebot from a micro:bit V2.
# Two published interfaces in one module: the functions that Vittascience's editor brings along (made by
# Krakenus/microbit-cutebot-micropython), and the class CUTEBOT of Elecfreaks' own Cutebot.py. Names, values and bytes on
# the wire are theirs; the code is our own. Runs on the real robot as well.

from microbit import i2c, pin8, pin12, pin13, pin14
import machine
import utime

# ---- The robot's controller: frames of four bytes -----------------------------------------------

I2C_ADDRESS = 0x10

MOTOR_LEFT = 1
MOTOR_RIGHT = 2
MOTOR_BACKWARD = 1
MOTOR_FORWARD = 2
MIN_SPEED = -100
MAX_SPEED = 100
FULL_SPEED = 80

RGB_LEFT = 4
RGB_RIGHT = 8
RGB_MIN = 0
RGB_MAX = 255

SERVO_1 = 5
SERVO_2 = 6
SERVO_ANGLE_MIN = 0
SERVO_ANGLE_MAX = 180

_USUAL_SPEED = 50


def _send(part, first, second=0, third=0):
    i2c.write(I2C_ADDRESS, bytes((part, first, second, third)))


def _between(value, least, most):
    return int(min(max(value, least), most))


# ---- Functions: drive -----------------------------------------------------------------------------


def _set_motor_speed(motor_position, speed):
    speed = _between(speed, MIN_SPEED, MAX_SPEED)
    _send(motor_position, MOTOR_BACKWARD if speed < 0 else MOTOR_FORWARD, abs(speed))


def set_motors_speed(left_speed, right_speed):
    """Speed of both wheels, -100 to 100; negative is backward."""
    _set_motor_speed(MOTOR_LEFT, left_speed)
    _set_motor_speed(MOTOR_RIGHT, right_speed)


def go_forward():
    set_motors_speed(_USUAL_SPEED, _USUAL_SPEED)


def go_backward():
    set_motors_speed(-_USUAL_SPEED, -_USUAL_SPEED)


def turn_left():
    """Turn left on the spot."""
    set_motors_speed(-_USUAL_SPEED, _USUAL_SPEED)


def turn_right():
    """Turn right on the spot."""
    set_motors_speed(_USUAL_SPEED, -_USUAL_SPEED)


def stop():
    set_motors_speed(0, 0)


# ---- Functions: lights and servos -------------------------------------------------------------------


def _set_rgb_led(led, r, g, b):
    _send(led, *[part if RGB_MIN <= part <= RGB_MAX else RGB_MIN for part in (r, g, b)])


def set_left_rgb_led(r=0, g=0, b=0):
    """Colour of the left headlamp, 0 to 255 each; a part beyond counts as 0."""
    _set_rgb_led(RGB_LEFT, r, g, b)


def set_right_rgb_led(r=0, g=0, b=0):
    """Colour of the right headlamp."""
    _set_rgb_led(RGB_RIGHT, r, g, b)


def _set_servo_angle(servo, angle):
    _send(servo, _between(angle, SERVO_ANGLE_MIN, SERVO_ANGLE_MAX))


def set_servo_1_angle(angle):
    """Turn the servo at port S1 to an angle from 0 to 180 degrees."""
    _set_servo_angle(SERVO_1, angle)


def set_servo_2_angle(angle):
    """Turn the servo at port S2."""
    _set_servo_angle(SERVO_2, angle)


# ---- Functions: sensors -----------------------------------------------------------------------------

SONAR_CM = 10
SONAR_IN = 20

_US_PER_CM = 58.2
_US_PER_INCH = 148


def _echo_us(timeout_us):
    """Length of the echo in microseconds, negative when there is none."""
    pin8.write_digital(0)
    utime.sleep_us(5)
    pin8.write_digital(1)
    utime.sleep_us(10)
    pin8.write_digital(0)
    return machine.time_pulse_us(pin12, 1, timeout_us)


def get_sonar_distance(unit=SONAR_CM, timeout_us=30000):
    """Distance to the nearest obstacle in cm or inches; negative when there is none."""
    echo = _echo_us(timeout_us)
    if echo < 0:
        return echo
    if unit == SONAR_CM:
        return echo / _US_PER_CM
    return echo / _US_PER_INCH if unit == SONAR_IN else -1.0


def has_left_track():
    """True if the left line sensor is on black."""
    return not pin13.read_digital()


def has_right_track():
    """True if the right line sensor is on black."""
    return not pin14.read_digital()


# ---- Elecfreaks' class ------------------------------------------------------------------------------

left = RGB_LEFT
right = RGB_RIGHT

_CM_PER_FOOT = 30.48


def _check(what, value, least, most):
    if not least <= value <= most:
        raise ValueError("%s is %s: it must be from %d to %d." % (what, value, least, most))


class CUTEBOT:
    """The robot."""

    def __init__(self):
        i2c.init()
        pin13.set_pull(pin13.PULL_UP)
        pin14.set_pull(pin14.PULL_UP)

    def set_motors_speed(self, left_wheel_speed, right_wheel_speed):
        """Speed of both wheels, -100 to 100; negative is backward."""
        wheels = ((MOTOR_LEFT, left_wheel_speed), (MOTOR_RIGHT, right_wheel_speed))
        for _, speed in wheels:
            _check("A wheel's speed", speed, MIN_SPEED, MAX_SPEED)
        for wheel, speed in wheels:
            _send(wheel, MOTOR_FORWARD if speed > 0 else MOTOR_BACKWARD, int(abs(speed)))

    def set_car_light(self, light, R, G, B):
        """Colour of a headlamp: left or right, then red, green and blue, 0 to 255 each."""
        if light not in (left, right):
            raise ValueError("light is %s: it must be left (4) or right (8)." % (light,))
        for part in (R, G, B):
            _check("A part of the colour", part, RGB_MIN, RGB_MAX)
        _send(light, R, G, B)

    def get_distance(self, unit=0):
        """Distance to the nearest obstacle in whole cm, or with unit 1 in feet; 0 when there is none."""
        cm = round(max(_echo_us(25000), 0) / _US_PER_CM)
        return round(cm / _CM_PER_FOOT, 2) if unit == 1 else cm

    def get_tracking(self):
        """The line sensors: 0 both on white, 10 the left one on black, 1 the right one, 11 both."""
        return 10 * has_left_track() + has_right_track()

    def set_servo(self, servo, angle):
        """Turn servo 1 or 2 to an angle from 0 to 180 degrees."""
        _check("servo", servo, 1, 2)
        _check("angle", angle, SERVO_ANGLE_MIN, SERVO_ANGLE_MAX)
        _send(SERVO_1 + servo - 1, int(angle))
