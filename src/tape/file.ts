import { isRecord } from '#core/record';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { parseSceneValue } from '#scene/parse';
import { serializeScene } from '#scene/serialize';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';
import { readDevices, readInputs } from './read-setup';
import { hashOfText, type TapeResult } from './result';
import type { Tape } from './tape';

/** The name of the format in the file. */
export const TAPE_FORMAT = 'parcours-tape';

/** The version that this app writes and the newest that it reads. The course within has a version of its own. */
export const TAPE_VERSION = 1;

/** Longest file that is read. Chosen: 100,000 inputs and eight devices with all their files. */
const MOST_CHARACTERS = 40_000_000;

/** A tape, with what was changed in its file after the recording, a sentence each; or why there is none. */
export type ParsedTape = { readonly tape: Tape; readonly changes: readonly string[] } | { readonly problem: string };

type Fields = Readonly<Record<string, unknown>>;

/** A tape as its file: JSON that ends in a newline. */
export function tapeToText({ madeBy, setup, untilUs, untilProgramEnds, result }: Tape): string {
  const { scene, devices, seed, reality, repl, inputs = [] } = setup;
  const course: unknown = JSON.parse(serializeScene(scene));
  const kept = { scene: course, devices, seed, reality, ...(repl && { repl }), inputs };
  const hashes = { programs: programHashes(devices), setup: hashOfText(JSON.stringify(kept)) };
  const lines = Object.entries({
    format: TAPE_FORMAT,
    version: TAPE_VERSION,
    madeBy,
    setup: kept,
    untilUs,
    untilProgramEnds,
    result,
    hashes,
  });
  return `{\n${lines.map(([name, value]) => `  ${JSON.stringify(name)}: ${JSON.stringify(value)}`).join(',\n')}\n}\n`;
}

/** Reads a tape's file. Never throws. */
export function parseTape(text: string): ParsedTape {
  const read = readJsonFile(text, 'recording', MOST_CHARACTERS);
  if ('problem' in read) return { problem: read.problem.message };
  const { value } = read;
  if (!isRecord(value) || value.format !== TAPE_FORMAT)
    return {
      problem: `This is no recorded run: "format" is not "${TAPE_FORMAT}". Record one with parcours run … --record FILE.`,
    };
  const version = versionProblem(value.version);
  if (version !== null) return { problem: version };
  try {
    return parsed(value);
  } catch (error) {
    if (error instanceof TypeError) return { problem: error.message };
    throw error;
  }
}

function versionProblem(version: unknown): string | null {
  if (version === TAPE_VERSION) return null;
  if (typeof version === 'number' && version > TAPE_VERSION)
    return `The recording is of version ${version}, this Parcours reads up to ${TAPE_VERSION}. Update Parcours.`;
  return `version: ${JSON.stringify(version) ?? 'nothing'} is no version of a recording.`;
}

/** @throws TypeError with a sentence for what is not as it must be */
function parsed(value: Fields): ParsedTape {
  const { setup, hashes } = value;
  if (!isRecord(setup)) throw new TypeError('setup: is missing; the recording is not whole.');
  const course = parseSceneValue(setup.scene);
  if (!('scene' in course)) return { problem: `setup.scene: ${summaryOf(course.problems)}` };
  const devices = readDevices(setup.devices);
  const run: RunSetup = {
    scene: course.scene,
    devices,
    seed: numberIn(setup, 'seed'),
    reality: numberIn(setup, 'reality'),
    ...(setup.repl === 'at-once' && { repl: setup.repl }),
    inputs: readInputs(setup.inputs),
  };
  const tape: Tape = {
    madeBy: typeof value.madeBy === 'string' ? value.madeBy.slice(0, 40) : '?',
    setup: run,
    untilUs: numberIn(value, 'untilUs'),
    untilProgramEnds: value.untilProgramEnds === true,
    result: readResult(value.result),
  };
  return { tape, changes: changesOf(setup, devices, hashes) };
}

/** What is not any more as it was recorded. */
function changesOf(setup: Fields, devices: readonly DeviceSetup[], hashes: unknown): readonly string[] {
  if (!isRecord(hashes) || !isRecord(hashes.programs))
    throw new TypeError('hashes: is missing; the recording is not whole.');
  const { programs } = hashes;
  const changed = Object.entries(programHashes(devices)).filter(([name, hash]) => programs[name] !== hash);
  if (changed.length > 0) return changed.map(([name]) => `The program of "${name}" was changed since the recording.`);
  if (hashes.setup === hashOfText(JSON.stringify(setup))) return [];
  return ['The set-up (course, settings or inputs) was changed since the recording.'];
}

const programHashes = (devices: readonly DeviceSetup[]): Readonly<Record<string, string>> =>
  Object.fromEntries(devices.map(({ name, files }) => [name, hashOfText(JSON.stringify(files))]));

function numberIn(fields: Fields, name: string): number {
  const value = fields[name];
  if (typeof value !== 'number' || !Number.isFinite(value) || value < 0)
    throw new TypeError(`${name}: must be a number from 0, not ${JSON.stringify(value) ?? 'nothing'}.`);
  return value;
}

function readResult(value: unknown): TapeResult {
  const isResult =
    isRecord(value) &&
    typeof value.traceHash === 'string' &&
    typeof value.simulatedUs === 'number' &&
    Array.isArray(value.devices) &&
    value.devices.every((device) => isRecord(device) && typeof device.name === 'string');
  if (!isResult) throw new TypeError('result: is missing or damaged; the recording is not whole.');
  return value as unknown as TapeResult;
}
