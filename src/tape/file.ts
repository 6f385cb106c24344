import { isRecord } from '#core/record';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { parseSceneValue } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';
import { readDevices, readInputs } from './read-setup';
import { hashOfText, type TapeResult } from './result';
import { isTapeFile, TAPE_FORMAT, type Tape } from './tape';

/** The version that this app writes and the newest that it reads. The course within has a version of its own. */
export const TAPE_VERSION = 1;

/** The physics of files that name none. */
const FIRST_PHYSICS = 1;

/** Longest file that is read. Chosen: 100,000 inputs and eight devices with all their files. */
const MOST_CHARACTERS = 40_000_000;

/** Why a file gives no tape: it is something else, of a newer version, or not whole. */
export type TapeFault = 'no-tape' | 'newer' | 'damaged';

/** A tape, with what was changed in its file after the recording, a sentence each; or why there is none. */
export type ParsedTape =
  | {
      readonly tape: Tape;
      readonly changes: readonly string[];
      /** The devices whose program was changed. */
      readonly changedPrograms: readonly string[];
    }
  | {
      readonly problem: string;
      readonly fault: TapeFault;
      /** The set-up of the run, if it can be read all the same. */
      readonly setup: RunSetup | null;
    };

type Fields = Readonly<Record<string, unknown>>;

/** A tape as its file: JSON that ends in a newline. */
export function tapeToText({ madeBy, physics, setup, untilUs, untilProgramEnds, result }: Tape): string {
  const kept = setupToValue(setup);
  const hashes = { programs: programHashes(setup.devices), setup: hashOfText(JSON.stringify(kept)) };
  const lines = Object.entries({
    format: TAPE_FORMAT,
    version: TAPE_VERSION,
    madeBy,
    physics,
    setup: kept,
    untilUs,
    untilProgramEnds,
    result,
    hashes,
  });
  return `{\n${lines.map(([name, value]) => `  ${JSON.stringify(name)}: ${JSON.stringify(value)}`).join(',\n')}\n}\n`;
}

function setupToValue({ scene, devices, seed, reality, repl, inputs = [] }: RunSetup): object {
  const course: unknown = JSON.parse(serializeScene(scene));
  return { scene: course, devices, seed, reality, ...(repl && { repl }), inputs };
}

/** The set-up as it is read back from its file: the run to record must be the run of that one. */
export const setupAsKept = (setup: RunSetup): RunSetup =>
  readSetup(JSON.parse(JSON.stringify(setupToValue(setup))) as Fields);

/** Reads a tape's file. Never throws. */
export function parseTape(text: string): ParsedTape {
  const read = readJsonFile(text, 'recording', MOST_CHARACTERS);
  if ('problem' in read) {
    const isCut = read.problem.code === 'not-json' && isTapeFile(text);
    return { problem: read.problem.message, fault: isCut ? 'damaged' : 'no-tape', setup: isCut ? setupIn(text) : null };
  }
  const { value } = read;
  if (!isRecord(value) || value.format !== TAPE_FORMAT) {
    const problem = `This is no recorded run: "format" is not "${TAPE_FORMAT}". Record one with parcours run … --record FILE.`;
    return { problem, fault: 'no-tape', setup: null };
  }
  const version = versionProblem(value.version);
  if (version !== null) return { ...version, setup: setupOrNull(value.setup) };
  try {
    return parsed(value);
  } catch (error) {
    if (error instanceof TypeError)
      return { problem: error.message, fault: 'damaged', setup: setupOrNull(value.setup) };
    throw error;
  }
}

function versionProblem(version: unknown): { readonly problem: string; readonly fault: TapeFault } | null {
  if (version === TAPE_VERSION) return null;
  if (typeof version === 'number' && version > TAPE_VERSION) {
    const problem = `The recording is of version ${version}, this Parcours reads up to ${TAPE_VERSION}. Update Parcours.`;
    return { problem, fault: 'newer' };
  }
  const problem = `version: ${JSON.stringify(version) ?? 'nothing'} is no version of a recording.`;
  return { problem, fault: 'damaged' };
}

/** @throws TypeError with a sentence for what is not as it must be */
function parsed(value: Fields): ParsedTape {
  const { setup, hashes } = value;
  if (!isRecord(setup)) throw new TypeError('setup: is missing; the recording is not whole.');
  const run = readSetup(setup);
  const tape: Tape = {
    madeBy: typeof value.madeBy === 'string' ? value.madeBy.slice(0, 40) : '?',
    physics: value.physics === undefined ? FIRST_PHYSICS : numberIn(value, 'physics'),
    setup: run,
    untilUs: Math.floor(numberIn(value, 'untilUs')),
    untilProgramEnds: value.untilProgramEnds === true,
    result: readResult(value.result),
  };
  return { tape, ...changesOf(setup, run.devices, hashes) };
}

/** @throws TypeError with a sentence for what is not as it must be */
function readSetup(setup: Fields): RunSetup {
  const course = parseSceneValue(setup.scene);
  if (!('scene' in course)) throw new TypeError(`setup.scene: ${summaryOf(course.problems)}`);
  return {
    scene: course.scene,
    devices: readDevices(setup.devices),
    seed: numberIn(setup, 'seed'),
    reality: numberIn(setup, 'reality'),
    ...(setup.repl === 'at-once' && { repl: setup.repl }),
    inputs: readInputs(setup.inputs),
  };
}

function setupOrNull(value: unknown): RunSetup | null {
  try {
    return isRecord(value) ? readSetup(value) : null;
  } catch (error) {
    if (error instanceof TypeError) return null;
    throw error;
  }
}

/** The set-up in a file that was cut off behind it: it has a line of its own. */
function setupIn(text: string): RunSetup | null {
  const [, line] = /^ *"setup": (.*),$/m.exec(text) ?? [];
  try {
    return setupOrNull(JSON.parse(line ?? 'null'));
  } catch {
    return null; // it is itself damaged
  }
}

/** The differences from what was recorded. */
function changesOf(
  setup: Fields,
  devices: readonly DeviceSetup[],
  hashes: unknown,
): { readonly changes: readonly string[]; readonly changedPrograms: readonly string[] } {
  if (!isRecord(hashes) || !isRecord(hashes.programs))
    throw new TypeError('hashes: is missing; the recording is not whole.');
  const { programs } = hashes;
  const changedPrograms = Object.entries(programHashes(devices))
    .filter(([name, hash]) => programs[name] !== hash)
    .map(([name]) => name);
  const changes = changedPrograms.map((name) => `The program of "${name}" was changed since the recording.`);
  const isSetupChanged = changes.length === 0 && hashes.setup !== hashOfText(JSON.stringify(setup));
  const ofSetup = 'The set-up (course, settings or inputs) was changed since the recording.';
  return { changes: isSetupChanged ? [ofSetup] : changes, changedPrograms };
}

const programHashes = (devices: readonly DeviceSetup[]): Readonly<Record<string, string>> =>
  Object.fromEntries(devices.map(({ name, files }) => [name, hashOfText(JSON.stringify(files))]));

function numberIn(fields: Fields, name: string): number {
  const value = fields[name];
  if (typeof value !== 'number' || !Number.isFinite(value) || value < 0)
    throw new TypeError(`${name}: must be a number from 0, not ${JSON.stringify(value) ?? 'nothing'}.`);
  return value;
}

/** Older pages wrote fractions of a µs, which no clock reaches. */
function readResult(value: unknown): TapeResult {
  const isResult =
    isRecord(value) &&
    typeof value.traceHash === 'string' &&
    typeof value.simulatedUs === 'number' &&
    Array.isArray(value.devices) &&
    value.devices.every((device) => isRecord(device) && typeof device.name === 'string');
  if (!isResult) throw new TypeError('result: is missing or damaged; the recording is not whole.');
  const result = value as unknown as TapeResult;
  return { ...result, simulatedUs: Math.floor(result.simulatedUs) };
}
