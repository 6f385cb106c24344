import { version } from '../../../package.json';
import { PHYSICS } from '#simulation/physics-version';
import { parseTape } from '#tape/file';
import { differences, type TapeResult } from '#tape/result';
import type { Tape } from '#tape/tape';
import type { ReplayOptions } from './replay-arguments';
import { readLimited } from '../read-files';
import { jsonLine } from '../report';
import { supervise, type Outcome } from '../supervise';
import { refuse } from '../results-out';
import type { Terminal } from '../terminal';
import { momentLines } from './moment-lines';

const MOST_BYTES = 80_000_000;

/**
 * Carries out `parcours replay`: runs a recorded run again and compares it, or stops it somewhere and shows the moment.
 *
 * @returns the exit code: 0 the same run, or the moment was reached; 1 another run, or it was not; 2 no recording
 */
export async function replay(options: ReplayOptions, terminal: Terminal): Promise<0 | 1 | 2> {
  const file = readLimited(options.tape, MOST_BYTES);
  if ('problem' in file) return refuse(file.problem, terminal);
  const read = parseTape(file.text);
  if ('problem' in read) return refuse(`${options.tape}: ${read.problem}`, terminal);
  const { tape, changes } = read;
  const device = placeOf(tape, options);
  if (typeof device === 'string') return refuse(device, terminal);
  const unfit = stopProblem(tape, options, device);
  if (unfit !== null) return refuse(unfit, terminal);
  for (const change of changes) terminal.message(`parcours: ${change}`);
  const outcome = await supervise(taskOf(tape, options, device), terminal);
  switch (outcome.type) {
    case 'refused':
      return refuse(`${options.tape}: ${outcome.problem}`, terminal);
    case 'broken':
      terminal.message(`parcours: something broke inside. Please report this.\n${outcome.problem}`);
      return 1;
    case 'ran':
      return options.stop === null
        ? tellComparison(tape, changes, outcome, options, terminal)
        : tellMoment(outcome, options, terminal);
  }
}

const taskOf = ({ setup, untilUs, untilProgramEnds }: Tape, { stop }: ReplayOptions, device: number) => ({
  ...{ setup, untilUs, untilProgramEnds, untilVerdict: false },
  ...{ traceFile: null, logFile: null, tapeFile: null },
  replay: { stop, device },
});

/** The place of the device that is looked at, or what is wrong with its name. */
function placeOf({ setup }: Tape, { device }: ReplayOptions): number | string {
  const names = setup.devices.map(({ name }) => name);
  const place = device === null ? 0 : names.indexOf(device);
  return place >= 0 ? place : `--device: "${device ?? ''}" is not in this recording. It has ${names.join(', ')}.`;
}

/** Why the run cannot stop there. */
function stopProblem({ setup, result }: Tape, { stop }: ReplayOptions, device: number): string | null {
  if (stop === null) return null;
  if ('timeUs' in stop)
    return stop.timeUs <= result.simulatedUs
      ? null
      : `--at: the recording ends after ${result.simulatedUs / 1_000_000} s.`;
  const files = Object.keys(setup.devices[device]?.files ?? {});
  return files.includes(stop.file)
    ? null
    : `--line: there is no "${stop.file}" on the board. It has ${files.join(', ')}.`;
}

const physicsWords = (physics: number): string =>
  `parcours: recorded with ${physics < PHYSICS ? 'an older' : 'a newer'} physics of the robots (${physics}; this is ${PHYSICS}): their way may differ, and the run can be looked at all the same (--at, --line).`;

type Ran = Extract<Outcome, { type: 'ran' }>;

function tellComparison(
  tape: Tape,
  changes: readonly string[],
  { report, consoles, replay: repeated }: Ran,
  { json }: ReplayOptions,
  terminal: Terminal,
): 0 | 1 {
  const differs =
    repeated === null ? ['The repetition did not come to its end.'] : differences(tape.result, repeated.result);
  const isSame = differs.length === 0 && changes.length === 0;
  for (const line of differs) terminal.message(`parcours: ${line}`);
  if (differs.length > 0 && tape.physics !== PHYSICS) terminal.message(physicsWords(tape.physics));
  else if (differs.length > 0 && tape.madeBy !== version)
    terminal.message(`parcours: recorded with Parcours ${tape.madeBy}, this is ${version}.`);
  terminal.message(isSame ? sameWords(tape.result) : 'parcours: This is not the run that was recorded.');
  if (json) {
    const { madeBy } = tape;
    const run: unknown = JSON.parse(jsonLine(report, consoles));
    terminal.line(JSON.stringify({ same: isSame, differs, changes, madeBy, run }));
  }
  return isSame ? 0 : 1;
}

const sameWords = ({ simulatedUs, traceHash }: TapeResult): string =>
  `parcours: The same run: ${simulatedUs / 1_000_000} s, hash ${traceHash.slice(0, 16)}…`;

function tellMoment({ replay: repeated }: Ran, { stop, json }: ReplayOptions, terminal: Terminal): 0 | 1 {
  const moment = repeated?.moment ?? null;
  if (moment === null) {
    const what =
      stop && 'line' in stop ? `${stop.file}:${stop.line} does not begin ${stop.hit} times` : 'it ended before';
    terminal.message(`parcours: not reached: ${what} in this run.`);
    return 1;
  }
  if (json) terminal.line(JSON.stringify(moment));
  else for (const line of momentLines(moment)) terminal.line(line);
  return 0;
}
