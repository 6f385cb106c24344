import { parseDuration } from '#core/duration';
import { command, type Given, type Options, type Problem } from '../commands/about';
import { numberOf } from '../number-of';

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

const options = {
  at: { value: 'TIME', help: 'stops after this simulated time, such as 3.2s, and shows the moment' },
  line: { value: 'FILE:LINE', help: 'stops where this line begins, such as main.py:14, and shows the moment' },
  hit: { value: 'N', help: 'with --line: the time that it begins, from 1; default: the first' },
  device: { value: 'NAME', help: 'which of several devices is looked at; default: the first' },
  json: { help: 'one line for other programs: the comparison, or the moment' },
  quiet: { help: "neither the program's output nor progress" },
} as const satisfies Options;

export const replayAbout = command({
  summary: 'runs a recorded run again and compares it, or shows a moment of it',
  usage: ['RUN.json [options]'],
  text: [
    'Runs a recorded run again and compares way, output, memory and time with the recording. With --at or --line it stops there instead and shows line, call stack, variables and robot.',
  ],
  words: [{ name: 'RUN.json', path: 'reads' }],
  options,
  exits: {
    0: 'the same run, or the moment',
    1: 'another run, or the line does not come so often',
    2: 'no recording, or something is wrong with the command',
  },
  examples: ['replay run.json', 'replay run.json --at 3.2s --json', 'replay run.json --line main.py:14 --hit 3'],
  read: readReplay,
});

type ReplayGiven = Given<typeof options>;

/** Reads the words after `parcours replay`. */
function readReplay([tape, ...more]: readonly string[], given: ReplayGiven): ReplayOptions | Problem {
  if (tape === undefined) return { problem: 'Which recording? For example: parcours replay run.json' };
  if (more[0] !== undefined) return { problem: `One recording at a time: what is "${more[0]}"?` };
  const stop = readStop(given);
  if (stop !== null && 'problem' in stop) return stop;
  return { tape, stop, device: given.last('device'), json: given.has('json'), quiet: given.has('quiet') };
}

/** The point at which a replay stops, or the problem with it. */
function readStop(given: ReplayGiven): StopAsked | Problem | null {
  const [at, place, hit] = [given.last('at'), given.last('line'), given.last('hit')];
  if (at !== null && place !== null) return { problem: '--at and --line: choose one of them.' };
  if (hit !== null && place === null) return { problem: '--hit needs a line: --line main.py:14 --hit 3' };
  if (at !== null) {
    const time = parseDuration(at);
    return 'problem' in time ? { problem: `--at: ${time.problem}` } : { timeUs: time.us };
  }
  if (place === null) return null;
  const [, file = '', line = ''] = /^(.+):(\d+)$/.exec(place) ?? [];
  if (file === '' || Number(line) === 0) return { problem: `--line: "${place}" is not like main.py:14.` };
  const times = numberOf(hit ?? '1');
  if (!(Number.isInteger(times) && times > 0))
    return { problem: `--hit: "${hit ?? ''}" is not a whole number from 1.` };
  return { file, line: Number(line), hit: times };
}
