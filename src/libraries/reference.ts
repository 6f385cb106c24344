import { fn, module, object, range, type, value, values, within, withWordsOf } from '#reference/table';
import type { Names, RobotReference } from '#reference/types';
import words from './words';

const moves = {
  forward: fn('(ms: float | None = None) -> None'),
  backward: fn('(ms: float | None = None) -> None'),
  left: fn('(ms: float | None = None) -> None'),
  right: fn('(ms: float | None = None) -> None'),
  leftArc: fn('(radius: float, ms: float | None = None) -> None'),
  rightArc: fn('(radius: float, ms: float | None = None) -> None'),
  stop: fn('() -> None'),
  setSpeed: within({ speed: range(0, 100) }, fn('(speed: int) -> None')),
  isMoving: fn('() -> bool'),
};
const keys = {
  isEnterHit: fn('() -> bool'),
  isEscapeHit: fn('() -> bool'),
  isLeftHit: fn('() -> bool'),
  isRightHit: fn('() -> bool'),
};
const brick = {
  ...keys,
  playTone: fn('(frequency: int, ms: int) -> None'),
  setLED: fn('(pattern: int) -> None'),
  exit: fn('() -> None'),
};

/** The same names as functions of the module, whose words they share. */
const sharedWords = (names: Names): Names =>
  Object.fromEntries(Object.entries(names).map(([name, entry]) => [name, withWordsOf(`simrobot.${name}`, entry)]));

const robot = {
  ...sharedWords(brick),
  addPart: fn('(part) -> None'),
  isRunning: fn('() -> bool'),
};

const told = withWordsOf('simrobot.RobotContext', fn('(*arguments) -> None'));

/** The names of simrobot.py with short descriptions. */
const simrobot = module('simrobot', {
  ...moves,
  ...brick,
  delay: within({ ms: { least: 0 } }, fn('(ms: float) -> None')),
  getDistance: fn('() -> int'),
  ...values('Motor', ['motA', 'motB', 'motL', 'motR']),
  us1: value('UltrasonicSensor'),
  ...values('LightSensor', ['ls1', 'ls2', 'ls3']),
  ...values('TouchSensor', ['ts1', 'ts2', 'ts3']),
  LegoRobot: type(['()'], robot),
  NxtRobot: withWordsOf('simrobot.LegoRobot', type(['()'], {}, 'LegoRobot')),
  Gear: type(['()'], { ...sharedWords(moves), getSpeed: fn('() -> int') }),
  Motor: type(['(port: int)'], {
    rotate: fn('(speed: int) -> None'),
    setSpeed: fn('(speed: int) -> None'),
    forward: fn('() -> None'),
    backward: fn('() -> None'),
    stop: fn('() -> None'),
  }),
  MotorPort: type([], { A: withWordsOf('simrobot.motA', value('int')), B: withWordsOf('simrobot.motB', value('int')) }),
  SensorPort: type([], {
    S1: value('int'),
    S2: value('int'),
    S3: value('int'),
    S4: value('int'),
  }),
  LightSensor: type(['(port: int)'], { getValue: fn('() -> int'), activate: fn('(on: bool) -> None') }),
  UltrasonicSensor: type(['(port: int = 0)'], { getDistance: withWordsOf('simrobot.getDistance', fn('() -> int')) }),
  TouchSensor: type(['(port: int)'], { isPressed: fn('() -> bool') }),
  Tools: object({ delay: withWordsOf('simrobot.delay', fn('(ms: float) -> None')) }),
  RobotContext: object({
    setStartPosition: told,
    setStartDirection: told,
    useBackground: told,
    useObstacle: told,
    useTarget: told,
    enableTrace: told,
    enableRotCenter: told,
    showNavigationBar: told,
    showStatusBar: told,
    setStatusText: told,
  }),
});

const sensor = { address: { least: 0 } };

/** The names of colour.py. */
const colour = module('colour', {
  name: within(sensor, fn('(address: int = 0x29) -> str')),
  hue: within(sensor, fn('(address: int = 0x29) -> int')),
  brightness: within(sensor, fn('(address: int = 0x29) -> int')),
  rgb: within(sensor, fn('(address: int = 0x29) -> tuple[int, int, int]')),
  raw: within(sensor, fn('(address: int = 0x29) -> tuple[int, int, int, int]')),
  calibrate: within(sensor, fn('(address: int = 0x29) -> None')),
});

const key = {
  is_pressed: withWordsOf('controller.is_pressed', fn('() -> bool')),
  was_pressed: withWordsOf('controller.was_pressed', fn('() -> bool')),
  get_presses: withWordsOf('controller.get_presses', fn('() -> int')),
};

/** The names of controller.py. */
const controller = module('controller', {
  joystick: object({
    get_x: fn('() -> float'),
    get_y: fn('() -> float'),
    get_z: fn('() -> int'),
    ...key,
    calibrate: fn(
      '(dead_zone: float, center_x: float = 0.0, center_y: float = 0.0, x_min: float = -1.0, x_max: float = 1.0, y_min: float = -1.0, y_max: float = 1.0) -> None',
    ),
  }),
  button_z: object(key),
  button_c: object(key),
  button_d: object(key),
  button_e: object(key),
  button_f: object(key),
  button_green: withWordsOf('controller.button_c', object(key)),
  button_yellow: withWordsOf('controller.button_d', object(key)),
  button_red: withWordsOf('controller.button_e', object(key)),
  button_blue: withWordsOf('controller.button_f', object(key)),
  trigger_left: object(key),
  trigger_right: object(key),
  vibrate: within({ state: range(0, 1) }, fn('(state: int) -> None')),
});

const found = { id: range(1, 255) };
const model = { number: range(0, 4) };
const thing = { id: value('int') };

/** The names of huskylens.py. */
const huskylens = module('huskylens', {
  Algorithm: type([], {
    ...values('int', [
      'FACE_RECOGNITION',
      'OBJECT_TRACKING',
      'OBJECT_RECOGNITION',
      'LINE_TRACKING',
      'COLOR_RECOGNITION',
    ]),
    ...values('int', ['TAG_RECOGNITION', 'OBJECT_CLASSIFICATION', 'QR_RECOGNITION', 'BARCODE_RECOGNITION']),
  }),
  Block: type(['(x: int, y: int, width: int, height: int, id: int)'], {
    ...values('int', ['x', 'y', 'width', 'height']),
    ...thing,
  }),
  Arrow: type(['(x_tail: int, y_tail: int, x_head: int, y_head: int, id: int)'], {
    ...values('int', ['x_tail', 'y_tail', 'x_head', 'y_head']),
    id: withWordsOf('huskylens.Block.id', value('int')),
    get_direction: fn('() -> int'),
  }),
  Huskylens: type(['()'], {
    algorithm: value('int'),
    initialize: fn('() -> bool'),
    is_pro: fn('() -> bool'),
    set_algorithm: within({ algorithm: range(0, 8) }, fn('(algorithm: int) -> bool')),
    get_all: fn('() -> list'),
    get_all_learned: fn('() -> list'),
    get_all_with_id: within(found, fn('(id: int) -> list')),
    get_one: fn('() -> Block | Arrow | None'),
    get_one_learned: fn('() -> Block | Arrow | None'),
    get_one_with_id: within(found, fn('(id: int) -> Block | Arrow | None')),
    learn: within(found, fn('(id: int, name: str | None = None) -> bool')),
    forget: fn('() -> bool'),
    attach_label: within(found, fn('(id: int, name: str) -> bool')),
    clear_labels: fn('() -> None'),
    add_text: within({ x: range(0, 319), y: range(0, 240) }, fn('(text: str, x: int, y: int) -> bool')),
    clear_texts: fn('() -> bool'),
    save_photo: fn('() -> bool'),
    save_screenshot: fn('() -> bool'),
    save_model: within(model, fn('(number: int) -> bool')),
    load_model: within(model, fn('(number: int) -> bool')),
  }),
});

/** The editor's reference of the libraries that belong to no robot. */
export const freeReference: Omit<RobotReference, 'robot'> = {
  modules: [simrobot, colour, controller, huskylens],
  texts: words,
};
