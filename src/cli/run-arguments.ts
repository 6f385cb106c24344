import { parseDuration } from '#core/duration';
import type { Language } from '#core/languages';
import type { OptionValues } from '#core/option';
import { leagueRules, type LeagueRules } from '#scene/league/league';
import { command, type Given, type Options, type Problem, type TextOf } from './commands/about';
import { notKnown } from './commands/nearest';
import { langOption, languageOf } from './commands/shared-options';
import { parseDevice, type DeviceOption } from './device-option';
import { numberOf } from './number-of';

/** The parts of a run. */
export interface SetupAsked {
  readonly program: string;
  readonly files: readonly string[];
  /** Devices besides the first, which runs the program. */
  readonly devices: readonly DeviceOption[];
  readonly scene: string | null;
  /** The rules of a scored line; `null`: the course's own. */
  readonly rules: LeagueRules | null;
  readonly robot: string;
  readonly board: string;
  /** Id of a firmware of the board; empty: the board's usual one. */
  readonly firmware: string;
  /** `null`: until the program ends. */
  readonly forUs: number | null;
  /** `null`: the project's, else 1. */
  readonly seed: number | null;
  /** `null`: the project's, else 0. */
  readonly reality: number | null;
  /** Whether the boards feel the arena; `null`: as the project has it, and a program alone does. */
  readonly senses: boolean | null;
  /** Options of the robot by id. */
  readonly robotOptions: OptionValues;
  /** A project file whose own robot drives. */
  readonly myRobot: string | null;
  readonly input: string | null;
}

/** The request to `parcours run`. */
export interface RunOptions extends SetupAsked {
  readonly trace: string | null;
  /** File for the recording of the run, to be repeated by `parcours replay`. */
  readonly record: string | null;
  /** File for the board's data log as CSV. */
  readonly log: string | null;
  /** True: the run ends when the course's task is decided. */
  readonly untilVerdict: boolean;
  /** True: a program that the real board would not understand is refused. */
  readonly strict: boolean;
  /** The language of explained errors, of what `--strict` finds, and of the result of the task. */
  readonly lang: Language;
  readonly json: boolean;
  readonly quiet: boolean;
}

/** The options that say which course and which robot. */
export const setupOptions = {
  scene: {
    heading: 'Which course, which robot',
    value: 'COURSE',
    choices: 'courses',
    path: 'reads',
    help: 'the course: its file, a project or a link that has one, a map of the editor for RoboCup Junior Rescue Line, the id of a ready one such as closed-line; without it: an empty arena of 1200 x 900 mm, the robot in its centre, heading to the right',
  },
  rules: {
    value: 'NAME',
    choices: leagueRules,
    help: 'of a rescue line: the rules by which its points are counted, with their year; default: those of the course, for a map line-2025',
  },
  robot: {
    value: 'NAME',
    choices: 'robots',
    help: "none: the microcomputer alone; default: the course's, else by what the program imports",
  },
  board: {
    value: 'NAME',
    choices: 'boards',
    help: "the microcomputer; default: the course's, else by what the program imports",
  },
  option: {
    value: 'ID=CHOICE',
    isRepeated: true,
    help: 'something about the robot, for instance what hangs on a servo port: S1=claw; an unknown one lists those there are',
  },
  firmware: {
    value: 'NAME',
    choices: 'firmwares',
    help: "the board's MicroPython; default: its usual one; for the micro:bit, newest has names that came later",
  },
  file: {
    value: 'DRIVER.py',
    path: 'reads',
    isRepeated: true,
    help: 'puts a further file on the board, for instance a module that MAIN.py imports',
  },
  device: {
    value: 'NAME=PROGRAM.py[,robot=ID|none][,board=ID][,option=CHOICE][,file=DRIVER.py]',
    isRepeated: true,
    help: "a further microcomputer in the same arena, with a robot or without, which hears the others by radio; up to seven. Its robot stands at the course's next start, or beside the first. A project or a link in the place of PROGRAM.py gives its first device. option=gamepad: a micro:bit in the hand, in a gamepad with stick and keys; of a robot option=S1=claw. What is printed has the name of its device before each line",
  },
  'my-robot': {
    value: 'FILE',
    path: 'reads',
    help: 'a project with a measured robot ("My robot" on the page): it drives as that one does',
  },
} as const satisfies Options;

/** The option that says how long a run takes. */
export const timeOption = {
  for: {
    heading: 'How long, and what happens',
    value: 'TIME',
    help: 'run for this long, for example 500ms, 20s or 2min, to the µs unless the program is inside a call that has begun; the world goes on when the program ends; default: until the program ends, at most 10 minutes of simulated time',
  },
} as const satisfies Options;

const verdictOption = {
  'until-verdict': {
    help: 'run until the task of the course is decided, or nothing more can happen; exit code 0 if it is passed, 3 if it is not',
  },
} as const satisfies Options;

/** The options that say what comes from outside and by chance. */
export const chanceOptions = {
  input: {
    value: 'FILE.json',
    path: 'reads',
    help: "buttons, the infrared remote control, the gamepad, sensors, typed text, the hand and changes of the course, each at its time; what is typed after the program's end goes to the REPL:",
    sample: [
      '[ { "at": "1s", "button": "a", "down": true },',
      '  { "at": "2s", "serial": "hello\\r\\n" },',
      '  { "at": "3s", "sensor": "lightLevel", "value": 10 },',
      '  { "at": "4s", "radio": "go" },',
      '  { "at": "4s", "lamp": "lamp-1", "on": true },',
      '  { "at": "4s", "barrier": "barrier-1", "open": true },',
      '  { "at": "4s", "device": "remote", "button": "b", "down": true },',
      '  { "at": "4s", "remote": "up", "for": "0.5s" },',
      '  { "at": "4s", "device": "pad", "stick": { "x": 0.5, "y": -1 } },',
      '  { "at": "4s", "device": "pad", "gamepad": "C", "down": true },',
      '  { "at": "5s", "place": { "xMm": 300, "yMm": 200, "headingDeg": 90 } },',
      '  { "at": "5s", "noProgress": true },',
      '  { "at": "6s", "edit": { "type": "remove", "ids": ["stroke-1"] } } ]',
    ],
  },
  seed: {
    value: 'NUMBER',
    help: 'where chance begins (default 1): random numbers repeat with it',
  },
  reality: {
    value: 'NUMBER',
    help: 'from 0, the ideal robot (default), to 1, one like the used robots of a school: unequal motors, weak battery, trembling sensors; from the seed',
  },
  senses: {
    value: 'on|off',
    choices: ['on', 'off'],
    help: 'whether compass, accelerometer, light and microphone feel the arena: a program alone does (on), a project as it was saved; what --input sets stays',
  },
} as const satisfies Options;

const options = {
  ...setupOptions,
  ...timeOption,
  ...verdictOption,
  ...chanceOptions,
  json: {
    heading: 'What you get',
    help: 'at the end one line with everything about the run, for other programs; "verdict" tells whether the task of the course is passed, "devices" what became of each device',
  },
  strict: { help: 'refuses to run what the real board would not understand, and says why' },
  lang: langOption('language of explained errors and of the result of the task; default: en'),
  log: { value: 'FILE.csv', path: 'writes', help: "the board's data log, for a spreadsheet" },
  trace: {
    value: 'FILE.csv',
    path: 'writes',
    help: 'where the robot was every 20 ms, for a spreadsheet; with several devices the last column names the device',
  },
  record: {
    value: 'RUN.json',
    path: 'writes',
    help: 'the whole run, to be run again, checked and looked into with replay',
  },
  quiet: { help: "neither the program's output nor progress" },
} as const satisfies Options;

export const runAbout = command({
  summary: 'runs a program with a simulated robot, without a window',
  usage: ['MAIN.py [options]', 'PROJECT.json|HEX.hex|LINK [options]'],
  text: [
    'A project or a link brings its program, course, robot and settings; options win over them.',
    'The program drives exactly as in the browser, only as fast as this computer can. What it prints appears here. Two runs with the same files, options and seed are the same.',
  ],
  words: [{ name: 'MAIN.py', path: 'reads' }],
  options,
  exits: {
    0: 'the program finished, or its time was over',
    1: 'it ended with an error',
    2: 'something is wrong with the command or a file',
    3: 'the task is not passed, with --until-verdict',
  },
  examples: [
    'run line.py --scene closed-line --for 60s',
    'run main.py --file my_driver.py --for 20s --trace way.csv',
    'run main.py --record run.json',
    'run robot.py --device remote=remote.py,robot=none',
  ],
  read: readRun,
});

type SetupName = TextOf<typeof setupOptions & typeof timeOption & typeof chanceOptions>;

/** The options of a command that makes runs of a program. */
interface SetupGiven {
  last(name: SetupName): string | null;
  all(name: SetupName): readonly string[];
}

/** Reads the words after `parcours run`. */
function readRun(words: readonly string[], given: Given<typeof options>): RunOptions | Problem {
  const setup = readSetup(words, given, 'run main.py');
  if ('problem' in setup) return setup;
  const language = languageOf(given.last('lang'));
  if ('problem' in language) return language;
  return {
    ...setup,
    trace: given.last('trace'),
    record: given.last('record'),
    log: given.last('log'),
    untilVerdict: given.has('until-verdict'),
    strict: given.has('strict'),
    ...language,
    json: given.has('json'),
    quiet: given.has('quiet'),
  };
}

/**
 * Reads the parts of a run.
 *
 * @param example of the command, for somebody who names no program
 */
export function readSetup(
  [program, ...more]: readonly string[],
  given: SetupGiven,
  example: string,
): SetupAsked | Problem {
  if (program === undefined) return { problem: `Which program? For example: parcours ${example}` };
  if (more[0] !== undefined)
    return { problem: `One program at a time: what is "${more[0]}"? Further files come with --file.` };
  const numbers = readNumbers(given);
  if ('problem' in numbers) return numbers;
  const senses = given.last('senses');
  if (senses !== null && senses !== 'on' && senses !== 'off')
    return { problem: `--senses: "${senses}" is neither on nor off.` };
  const robotOptions = readOptions(given.all('option'));
  if (typeof robotOptions === 'string') return { problem: robotOptions };
  const devices = readDevices(given.all('device'));
  if (typeof devices === 'string') return { problem: devices };
  const rules = rulesOf(given.last('rules'));
  if ('problem' in rules) return rules;
  return {
    program,
    files: given.all('file'),
    devices,
    scene: given.last('scene'),
    ...rules,
    robot: given.last('robot') ?? 'auto',
    board: given.last('board') ?? 'auto',
    firmware: given.last('firmware') ?? '',
    ...numbers,
    senses: senses === null ? null : senses === 'on',
    robotOptions,
    myRobot: given.last('my-robot'),
    input: given.last('input'),
  };
}

/** The rules of a scored line by their name. */
export function rulesOf(word: string | null): Pick<SetupAsked, 'rules'> | Problem {
  const rules = leagueRules.find((one) => one === word) ?? null;
  return rules === null && word !== null ? { problem: notKnown('rules', word, leagueRules) } : { rules };
}

/** Time, seed and reality, or the problem with one of them. */
function readNumbers(given: SetupGiven): Pick<SetupAsked, 'forUs' | 'seed' | 'reality'> | Problem {
  const forText = given.last('for');
  const duration = forText === null ? null : parseDuration(forText);
  if (duration && 'problem' in duration) return { problem: `--for: ${duration.problem}` };
  if (duration?.us === 0) return { problem: `--for: "${forText ?? ''}" is no time at all.` };
  const [seedText, realityText] = [given.last('seed'), given.last('reality')];
  const seed = seedText === null ? null : numberOf(seedText);
  if (seed !== null && !(Number.isInteger(seed) && seed >= 0 && seed <= 0xffffffff))
    return { problem: `--seed: "${seedText ?? ''}" is not a whole number from 0 to 4294967295.` };
  const reality = realityText === null ? null : numberOf(realityText);
  if (reality !== null && !(reality >= 0 && reality <= 1))
    return { problem: `--reality: "${realityText ?? ''}" is not a number from 0 to 1.` };
  return { forUs: duration?.us ?? null, seed, reality };
}

/** The further devices in their order; or what is wrong with one of them. */
function readDevices(texts: readonly string[]): readonly DeviceOption[] | string {
  const devices: DeviceOption[] = [];
  for (const text of texts) {
    const device = parseDevice(text);
    if (typeof device === 'string') return device;
    devices.push(device);
  }
  return devices;
}

/** Options of the robot from `ID=CHOICE`, the last of an id wins; or what is wrong with one of them. */
function readOptions(texts: readonly string[]): OptionValues | string {
  const chosen = new Map<string, string>();
  for (const text of texts) {
    const [, id, choice] = /^([^=]+)=(.+)$/.exec(text) ?? [];
    if (id === undefined || choice === undefined) return `--option: "${text}" is not like S1=claw.`;
    chosen.set(id, choice);
  }
  return Object.fromEntries(chosen);
}
