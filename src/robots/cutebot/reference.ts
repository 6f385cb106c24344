import { fn, module, range, type, value, within, withWordsOf } from '#reference/table';
import type { RobotReference } from '#reference/types';
import words from './words/reference';

const NAME = 'cutebot';

/** Numbers that share the words of the first of them. */
const numbers = (first: string, ...others: readonly string[]) =>
  Object.fromEntries([first, ...others].map((name) => [name, withWordsOf(`${NAME}.${first}`, value('int'))]));

const color = '(r: int = 0, g: int = 0, b: int = 0) -> None';

/** The names of this robot's library (library/cutebot.py), which answers to the name of Elecfreaks' file, too. */
const cutebot = module(
  NAME,
  {
    set_motors_speed: within(
      { left_speed: range(-100, 100), right_speed: range(-100, 100) },
      fn('(left_speed: int, right_speed: int) -> None'),
    ),
    go_forward: fn('() -> None'),
    go_backward: fn('() -> None'),
    turn_left: fn('() -> None'),
    turn_right: fn('() -> None'),
    stop: fn('() -> None'),
    get_sonar_distance: fn('(unit: int = SONAR_CM, timeout_us: int = 30000) -> float'),
    has_left_track: fn('() -> bool'),
    has_right_track: fn('() -> bool'),
    set_left_rgb_led: fn(color),
    set_right_rgb_led: fn(color),
    set_servo_1_angle: fn('(angle: int) -> None'),
    set_servo_2_angle: fn('(angle: int) -> None'),
    CUTEBOT: type(['()'], {
      set_motors_speed: fn('(left_wheel_speed: int, right_wheel_speed: int) -> None'),
      set_car_light: fn('(light: int, R: int, G: int, B: int) -> None'),
      get_distance: fn('(unit: int = 0) -> float'),
      get_tracking: fn('() -> int'),
      set_servo: fn('(servo: int, angle: int) -> None'),
    }),
    left: value('int'),
    right: value('int'),
    ...numbers('MAX_SPEED', 'MIN_SPEED', 'FULL_SPEED'),
    ...numbers('MOTOR_LEFT', 'MOTOR_RIGHT', 'MOTOR_BACKWARD', 'MOTOR_FORWARD'),
    ...numbers('RGB_LEFT', 'RGB_RIGHT', 'RGB_MIN', 'RGB_MAX'),
    ...numbers('SERVO_1', 'SERVO_2', 'SERVO_ANGLE_MIN', 'SERVO_ANGLE_MAX'),
    ...numbers('SONAR_CM', 'SONAR_IN'),
    I2C_ADDRESS: value('int'),
  },
  ['Cutebot'],
);

/** The Cutebot's library, for the editor. */
export const cutebotReference: RobotReference = {
  robot: 'cutebot',
  modules: [cutebot],
  texts: words,
  misnamed: {
    forward: 'go_forward',
    backward: 'go_backward',
    left: 'turn_left',
    right: 'turn_right',
    getDistance: 'get_sonar_distance',
  },
};
