/**
 * The commands for beginners' programs, by robot. Chosen by hand: few, and each good for a line that does something.
 */
import type { RobotReference } from '#reference/types';
import { robotReferences } from '#robots/references';

/** A command that the palette writes. */
export interface PaletteCommand {
  readonly id: CommandId;
  /** A template of CodeMirror: a tab indents, `${1:50}` is a place to type over, `${}` where one goes on. */
  readonly code: string;
  /** Names that a module has to bring: `display`. */
  readonly needs: readonly string[];
  /** The name in `code` whose words in the reference explain it; `null`: it has words of its own. */
  readonly said: string | null;
}

const BODY = '\n\t${}';

type Way = Omit<PaletteCommand, 'id'>;

/** A call whose own words in the reference explain it. */
const call = (name: string, values = '') => ({
  code: `${name}(${values})`,
  needs: [name.split('.')[0] ?? ''],
  said: name,
});

const when = (condition: string, said: string) => ({
  code: `if ${condition}:${BODY}`,
  needs: [said.split('.')[0] ?? ''],
  said,
});

/** Assigns the result of a call to a name. */
const keep = (name: string, said: string) => ({
  code: `${name} = ${said}()`,
  needs: [said.split('.')[0] ?? ''],
  said,
});

const own = (code: string, ...needs: readonly string[]) => ({ code, needs, said: null });

const table = {
  forward: call('forward'),
  backward: call('backward'),
  left: call('left'),
  right: call('right'),
  leftArc: call('leftArc', '${1:0.2}'),
  rightArc: call('rightArc', '${1:0.2}'),
  stop: call('stop'),
  setSpeed: call('setSpeed', '${1:50}'),
  wheels: call('set_motors_speed', '${1:50}, ${2:30}'),

  scroll: call('display.scroll', '"${1:Hi!}"'),
  show: call('display.show', '"${1:A}"'),
  image: own('display.show(Image.${1:HEART})', 'display', 'Image'),
  pixel: call('display.set_pixel', '${1:2}, ${2:2}, ${3:9}'),
  clear: call('display.clear'),
  print: { code: 'print("${1:Hi!}")', needs: [], said: 'print' },

  pressedA: when('button_a.is_pressed()', 'button_a.is_pressed'),
  pressedB: when('button_b.is_pressed()', 'button_b.is_pressed'),
  wasPressedA: when('button_a.was_pressed()', 'button_a.was_pressed'),
  logo: when('pin_logo.is_touched()', 'pin_logo.is_touched'),

  distance: keep('distance', 'getDistance'),
  near: when('getDistance() < ${1:20}', 'getDistance'),
  leftDark: own(`if irLeft.read_digital() == 0:${BODY}`, 'irLeft'),
  rightDark: own(`if irRight.read_digital() == 0:${BODY}`, 'irRight'),
  middleDark: own(`if irM.read_digital() == 0:${BODY}`, 'irM'),
  bumper: own(`if tsValue() == 1:${BODY}`, 'tsValue'),
  shaken: when('accelerometer.was_gesture("${1:shake}")', 'accelerometer.was_gesture'),
  tilt: keep('tilt', 'accelerometer.get_x'),
  temperature: keep('degrees', 'temperature'),
  brightness: keep('brightness', 'display.read_light_level'),
  loudness: keep('loudness', 'microphone.sound_level'),
  heading: keep('heading', 'compass.heading'),

  setLED: call('setLED', '${1:1}'),
  setLEDLeft: call('setLEDLeft', '${1:1}'),
  setLEDRight: call('setLEDRight', '${1:1}'),
  fillRGB: call('fillRGB', '${1:255}, ${2:0}, ${3:0}'),
  clearRGB: call('clearRGB'),
  lampLeft: call('set_left_rgb_led', '${1:255}, ${2:0}, ${3:0}'),
  lampRight: call('set_right_rgb_led', '${1:255}, ${2:0}, ${3:0}'),
  beep: call('beep'),
  setAlarm: call('setAlarm', '${1:1}'),
  melody: call('music.play', 'music.${1:ODE}'),
  tone: call('music.pitch', '${1:440}, ${2:500}'),

  delay: call('delay', '${1:500}'),
  sleep: call('sleep', '${1:500}'),
  waitForA: own('while not button_a.was_pressed():\n\tsleep(${1:10})', 'button_a', 'sleep'),
  waitUntilNear: own('while getDistance() > ${1:20}:\n\tdelay(${2:20})', 'getDistance', 'delay'),

  forever: own(`while True:${BODY}`),
  times: own(`for i in range(\${1:4}):${BODY}`),
  while: own(`while \${1:number < 10}:${BODY}`),
  break: { code: 'break', needs: [], said: 'break' },

  if: own(`if \${1:number > 5}:${BODY}`),
  ifElse: own(`if \${1:number > 5}:${BODY}\nelse:${BODY}`),

  set: own('${1:number} = ${2:0}'),
  increase: own('number = number + ${1:1}'),
  random: { code: 'number = randint(${1:1}, ${2:6})', needs: ['randint'], said: 'randint' },
  define: own(`def \${1:dance}():${BODY}`),
} as const;

/** The name of a command, by which its texts are found. */
export type CommandId = keyof typeof table;

/** Other ways to write a command, for robots whose libraries lack the names of the usual one. */
const otherwise: Partial<Record<CommandId, readonly Way[]>> = {
  delay: [table.sleep],
  waitUntilNear: [own('while getDistance() > ${1:20}:\n\tsleep(${2:20})', 'getDistance', 'sleep')],
  leftDark: [
    own(`if irLeftValue() == 0:${BODY}`, 'irLeftValue'),
    own(`if getLine(0) == 1:${BODY}`, 'getLine'),
    own(`if has_left_track():${BODY}`, 'has_left_track'),
  ],
  rightDark: [
    own(`if irRightValue() == 0:${BODY}`, 'irRightValue'),
    own(`if getLine(1) == 1:${BODY}`, 'getLine'),
    own(`if has_right_track():${BODY}`, 'has_right_track'),
  ],
  fillRGB: [call('rgbLED', '${1:255}, ${2:0}, ${3:0}'), call('fill', '${1:255}, ${2:0}, ${3:0}')],
};

export const commandNamed = (id: CommandId): PaletteCommand => ({ id, ...table[id] });

/** The groups, in the order of the palette. */
export const GROUPS = ['drive', 'show', 'buttons', 'sensors', 'light', 'wait', 'repeat', 'when', 'values'] as const;
export type GroupId = (typeof GROUPS)[number];

type Choice = Partial<Record<GroupId, readonly CommandId[]>>;

/** The commands for every program: the microcomputer and Python. */
const board: Choice = {
  show: ['show', 'scroll', 'image', 'pixel', 'clear', 'print'],
  buttons: ['pressedA', 'pressedB', 'wasPressedA', 'logo'],
  sensors: ['shaken', 'tilt', 'temperature', 'brightness', 'loudness', 'heading'],
  light: ['melody', 'tone'],
  wait: ['sleep', 'waitForA'],
  repeat: ['forever', 'times', 'while', 'break'],
  when: ['if', 'ifElse'],
  values: ['set', 'increase', 'random', 'define'],
};

/** The commands that robots put in the place of the board's, as far as their libraries have the names. */
const ofRobots: Choice = {
  drive: ['forward', 'backward', 'left', 'right', 'leftArc', 'rightArc', 'stop', 'setSpeed', 'wheels'],
  wait: ['delay', 'waitUntilNear', 'waitForA'],
  sensors: ['distance', 'near', 'leftDark', 'rightDark', 'middleDark', 'bumper', 'shaken'],
  // prettier-ignore
  light: [
    'setLED', 'setLEDLeft', 'setLEDRight', 'lampLeft', 'lampRight', 'fillRGB', 'clearRGB', 'beep', 'setAlarm', 'melody',
  ],
};

/** A group of the palette with its commands. */
export interface PaletteGroup {
  readonly id: GroupId;
  readonly commands: readonly PaletteCommand[];
}

/** Names that are not the robot's: of the board, and so always there. */
const ofBoards = new Set(['accelerometer', 'button_a', 'music', 'sleep']);

/** A command with names that a robot's reference tells in its first module, which is for pupils; none if they lack. */
function written(id: CommandId, { modules: [first], misnamed = {} }: RobotReference): readonly PaletteCommand[] {
  const names = new Set([...Object.keys(first?.names ?? {}), ...ofBoards]);
  const ways = [table[id], ...(otherwise[id] ?? [])].map((way) => called(way, misnamed));
  const way = ways.find(({ needs }) => needs.every((name) => names.has(name)));
  return way === undefined ? [] : [{ id, ...way }];
}

/** A way to write a command with the name that a library gives its call, if that is another one. */
function called(way: Way, misnamed: Readonly<Record<string, string>>): Way {
  const { said, needs, code } = way;
  const other = said === null ? undefined : misnamed[said];
  if (said === null || other === undefined) return way;
  return { code: code.replace(said, other), said: other, needs: needs.map((name) => (name === said ? other : name)) };
}

/** The commands of a group for a robot; `null`: those of the microcomputer. */
function commandsIn(id: GroupId, reference: RobotReference | null): readonly PaletteCommand[] {
  const own = reference === null ? undefined : ofRobots[id];
  if (reference === null || own === undefined) return board[id]?.map(commandNamed) ?? [];
  return own.flatMap((command) => written(command, reference));
}

/** The commands for a robot, by group; without a robot those of the microcomputer alone. */
export function commandsFor(robot: string | null): readonly PaletteGroup[] {
  const reference = robotReferences.find((it) => it.robot === robot) ?? null;
  return GROUPS.map((id) => ({ id, commands: commandsIn(id, reference) })).filter(
    ({ commands }) => commands.length > 0,
  );
}

/** A template as one reads it: `setSpeed(50)`, with `…` for the lines that belong inside. */
export const codeShown = (code: string): string =>
  code
    .replace(/\$\{(?:\d+:)?([^{}]*)\}/g, (_field, text: string) => (text === '' ? '…' : text))
    .replaceAll('\t', '    ');
