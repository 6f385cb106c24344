import { parseArgs } from 'node:util';
import type { OptionValues } from '#core/option';
import { LANGUAGES, type Language } from '#core/languages';
import { checkTexts, parseCheck, type CheckOptions } from './check/check-arguments';
import { classTexts, parseClassCommand, type ClassOptions } from './class/class-arguments';
import { convertTexts, parseConvert, type ConvertOptions } from './convert/convert-arguments';
import { parseDevice, type DeviceOption } from './device-option';
import { parseDuration } from '#core/duration';

/** The request to `parcours run`. */
export interface RunOptions {
  readonly program: string;
  readonly files: readonly string[];
  /** Devices besides the first, which runs the program. */
  readonly devices: readonly DeviceOption[];
  readonly scene: string | null;
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
  readonly trace: string | null;
  /** File for the recording of the run, to be repeated by `parcours replay`. */
  readonly record: string | null;
  /** File for the board's data log as CSV. */
  readonly log: string | null;
  /** True: the run ends when the course's task is decided. */
  readonly untilVerdict: boolean;
  /** True: a program that the real board would not understand is refused. */
  readonly strict: boolean;
  /** The language in which errors and what `--strict` finds are explained. */
  readonly lang: Language;
  readonly json: boolean;
  readonly quiet: boolean;
}

/** The request to `parcours probe compare`. */
export interface ProbeOptions {
  /** The saved output of a board. */
  readonly board: string;
  /** The table of another board; `null`: the same programs are run here. */
  readonly other: string | null;
}

/** The point at which a repeated run stops. */
export type StopAsked =
  { readonly timeUs: number } | { readonly file: string; readonly line: number; readonly hit: number };

/** The request to `parcours replay`. */
export interface ReplayOptions {
  /** The recording. */
  readonly tape: string;
  /** `null`: nowhere; the whole run is compared with the recording. */
  readonly stop: StopAsked | null;
  /** Name of the device that is looked at; `null`: the first. */
  readonly device: string | null;
  readonly json: boolean;
  readonly quiet: boolean;
}

/** The request on the command line. */
export type Command =
  | { readonly type: 'run'; readonly options: RunOptions }
  | { readonly type: 'replay'; readonly options: ReplayOptions }
  | { readonly type: 'check'; readonly options: CheckOptions }
  | { readonly type: 'class'; readonly options: ClassOptions }
  | { readonly type: 'convert'; readonly options: ConvertOptions }
  | { readonly type: 'probe'; readonly options: ProbeOptions }
  | { readonly type: 'help' }
  | { readonly type: 'version' }
  | { readonly type: 'bad'; readonly problem: string };

const texts = [
  ...([
    'file',
    'device',
    'scene',
    'robot',
    'board',
    'firmware',
    'option',
    'for',
    'seed',
    'reality',
    'senses',
    'my-robot',
    'input',
    'trace',
    'record',
    'log',
  ] as const),
  'at',
  'line',
  'hit',
  ...checkTexts,
  ...convertTexts,
  ...Object.values(classTexts).flat(),
] as const;
const flags = ['until-verdict', 'strict', 'json', 'quiet', 'help', 'version'] as const;

type Text = (typeof texts)[number];
type Flag = (typeof flags)[number];

const isText = (name: string): name is Text => (texts as readonly string[]).includes(name);
const isFlag = (name: string): name is Flag => (flags as readonly string[]).includes(name);

const bad = (problem: string): Command => ({ type: 'bad', problem });

/** Reads the words after `parcours`. */
export function parseCommand(words: readonly string[]): Command {
  const options = {
    ...Object.fromEntries(texts.map((name) => [name, { type: 'string' as const }])),
    ...Object.fromEntries(flags.map((name) => [name, { type: 'boolean' as const }])),
    help: { type: 'boolean' as const, short: 'h' },
  };
  const { tokens } = parseArgs({ args: [...words], options, strict: false, allowPositionals: true, tokens: true });
  const given = new Map<Text, string[]>();
  const set = new Set<Flag>();
  const positionals: string[] = [];
  for (const token of tokens) {
    if (token.kind === 'positional') positionals.push(token.value);
    if (token.kind !== 'option') continue;
    const { name, rawName, value } = token;
    if (isFlag(name)) {
      if (value !== undefined) return bad(`${rawName} takes no value.`);
      set.add(name);
    } else if (isText(name)) {
      if (value === undefined || value === '' || (value.startsWith('--') && !token.inlineValue))
        return bad(`${rawName} needs a value.`);
      given.set(name, [...(given.get(name) ?? []), value]);
    } else {
      return bad(`Unknown option ${rawName}. Known: ${[...texts, ...flags].map((known) => `--${known}`).join(', ')}.`);
    }
  }
  return commandOf(positionals, given, set);
}

function commandOf(
  positionals: readonly string[],
  given: ReadonlyMap<Text, string[]>,
  set: ReadonlySet<Flag>,
): Command {
  if (set.has('help') || (positionals[0] === 'help' && positionals.length === 1)) return { type: 'help' };
  if (set.has('version')) return { type: 'version' };
  const [command, program, ...more] = positionals;
  if (command === undefined) return bad('What shall it do? For example: parcours run main.py');
  if (command === 'probe') return probeCommand(program, more);
  if (command === 'replay') return replayCommand(program, more, given, set);
  if (command === 'check') {
    const words = program === undefined ? [] : [program, ...more];
    const options = parseCheck(words, given, set, process.env);
    return 'problem' in options ? bad(options.problem) : { type: 'check', options };
  }
  if (command === 'class') {
    const options = parseClassCommand(positionals.slice(1), given, set, today());
    return 'problem' in options ? bad(options.problem) : { type: 'class', options };
  }
  if (command === 'convert') {
    const options = parseConvert(positionals.slice(1), given, set);
    return 'problem' in options ? bad(options.problem) : { type: 'convert', options };
  }
  const ofCheck = checkTexts.find((name) => name !== 'lang' && given.has(name));
  if (ofCheck !== undefined)
    return bad(`--${ofCheck} is for hand-ins: parcours check closed-line class/ --${ofCheck} …`);
  const [ofReplay] = ['at', 'line', 'hit'].filter((name) => isText(name) && given.has(name));
  if (ofReplay !== undefined)
    return bad(`--${ofReplay} is for a recorded run: parcours replay run.json --${ofReplay} …`);
  const ofConvert = convertTexts.find((name) => given.has(name));
  if (ofConvert !== undefined)
    return bad(`--${ofConvert} is for another form of your work: parcours convert main.py --${ofConvert} …`);
  if (command !== 'run') return bad(`Unknown command "${command}". For example: parcours run main.py`);
  if (program === undefined) return bad('Which program? For example: parcours run main.py');
  if (more.length > 0) return bad(`One program at a time: what is "${more[0] ?? ''}"? Further files come with --file.`);
  return runCommand(program, given, set);
}

/** The day by this computer's calendar. */
function today(): string {
  const now = new Date();
  const two = (number: number): string => String(number).padStart(2, '0');
  return `${String(now.getFullYear())}-${two(now.getMonth() + 1)}-${two(now.getDate())}`;
}

function probeCommand(action: string | undefined, [board, other, ...more]: readonly string[]): Command {
  const example = 'For example: parcours probe compare board.csv';
  if (action !== 'compare') return bad(`What shall be done with the probe? ${example}`);
  if (board === undefined) return bad(`Which output of a board? ${example}`);
  if (more.length > 0) return bad(`Two tables at most: what is "${more[0] ?? ''}"?`);
  return { type: 'probe', options: { board, other: other ?? null } };
}

function replayCommand(
  tape: string | undefined,
  more: readonly string[],
  given: ReadonlyMap<Text, string[]>,
  set: ReadonlySet<Flag>,
): Command {
  if (tape === undefined) return bad('Which recording? For example: parcours replay run.json');
  if (more.length > 0) return bad(`One recording at a time: what is "${more[0] ?? ''}"?`);
  const strange = [...given.keys(), ...set].find((name) => !REPLAY_OPTIONS.includes(name));
  if (strange !== undefined)
    return bad(
      `--${strange} is not for replay: everything else is in the recording. Known: ${REPLAY_OPTIONS.map((name) => `--${name}`).join(', ')}.`,
    );
  const stop = readStop(given);
  if (typeof stop === 'string') return bad(stop);
  const device = given.get('device')?.at(-1) ?? null;
  return { type: 'replay', options: { tape, stop, device, json: set.has('json'), quiet: set.has('quiet') } };
}

const REPLAY_OPTIONS: readonly string[] = ['at', 'line', 'hit', 'device', 'json', 'quiet'];

/** The point at which a replay stops, or the problem with it. */
function readStop(given: ReadonlyMap<Text, string[]>): StopAsked | string | null {
  const last = (name: Text): string | undefined => given.get(name)?.at(-1);
  const [at, place, hit] = [last('at'), last('line'), last('hit')];
  if (at !== undefined && place !== undefined) return '--at and --line: choose one of them.';
  if (hit !== undefined && place === undefined) return '--hit needs a line: --line main.py:14 --hit 3';
  if (at !== undefined) {
    const time = parseDuration(at);
    return 'problem' in time ? `--at: ${time.problem}` : { timeUs: time.us };
  }
  if (place === undefined) return null;
  const [, file = '', line = ''] = /^(.+):(\d+)$/.exec(place) ?? [];
  if (file === '' || Number(line) === 0) return `--line: "${place}" is not like main.py:14.`;
  const times = numberOf(hit ?? '1');
  if (!(Number.isInteger(times) && times > 0)) return `--hit: "${hit ?? ''}" is not a whole number from 1.`;
  return { file, line: Number(line), hit: times };
}

function runCommand(program: string, given: ReadonlyMap<Text, string[]>, set: ReadonlySet<Flag>): Command {
  const last = (name: Text): string | undefined => given.get(name)?.at(-1);
  const forText = last('for');
  const duration = forText === undefined ? null : parseDuration(forText);
  if (duration && 'problem' in duration) return bad(`--for: ${duration.problem}`);
  if (duration?.us === 0) return bad(`--for: "${forText ?? ''}" is no time at all.`);
  const seed = given.has('seed') ? numberOf(last('seed') ?? '') : null;
  if (seed !== null && !(Number.isInteger(seed) && seed >= 0 && seed <= 0xffffffff)) {
    return bad(`--seed: "${last('seed') ?? ''}" is not a whole number from 0 to 4294967295.`);
  }
  const reality = given.has('reality') ? numberOf(last('reality') ?? '') : null;
  if (reality !== null && !(reality >= 0 && reality <= 1))
    return bad(`--reality: "${last('reality') ?? ''}" is not a number from 0 to 1.`);
  const senses = last('senses');
  if (senses !== undefined && senses !== 'on' && senses !== 'off')
    return bad(`--senses: "${senses}" is neither on nor off.`);
  const robotOptions = readOptions(given.get('option') ?? []);
  if (typeof robotOptions === 'string') return bad(robotOptions);
  const devices = readDevices(given.get('device') ?? []);
  if (typeof devices === 'string') return bad(devices);
  const langText = last('lang') ?? 'en';
  const lang = LANGUAGES.find((known) => known === langText);
  if (lang === undefined) return bad(`--lang: "${langText}" is not available. Known: ${LANGUAGES.join(', ')}.`);
  return {
    type: 'run',
    options: {
      program,
      files: given.get('file') ?? [],
      devices,
      scene: last('scene') ?? null,
      robot: last('robot') ?? 'auto',
      board: last('board') ?? 'auto',
      firmware: last('firmware') ?? '',
      forUs: duration?.us ?? null,
      seed,
      reality,
      senses: senses === undefined ? null : senses === 'on',
      robotOptions,
      myRobot: last('my-robot') ?? null,
      input: last('input') ?? null,
      trace: last('trace') ?? null,
      record: last('record') ?? null,
      log: last('log') ?? null,
      untilVerdict: set.has('until-verdict'),
      strict: set.has('strict'),
      lang,
      json: set.has('json'),
      quiet: set.has('quiet'),
    },
  };
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
  const options = new Map<string, string>();
  for (const text of texts) {
    const [, id, choice] = /^([^=]+)=(.+)$/.exec(text) ?? [];
    if (id === undefined || choice === undefined) return `--option: "${text}" is not like S1=claw.`;
    options.set(id, choice);
  }
  return Object.fromEntries(options);
}

/** NaN for everything that is not a plain decimal number. */
const numberOf = (text: string): number => (/^\d+(\.\d+)?$/.test(text) ? Number(text) : NaN);
