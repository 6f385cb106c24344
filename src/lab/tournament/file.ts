/**
 * A tournament as a file that anybody can check by running it again, `parcours-tournament` version 1: the course, the programs, how
 * they play, and what came of it.
 */
import { isRecord } from '#core/record';
import { isSame } from '#core/same';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { parseSceneValue } from '#scene/parse';
import { versionProblem } from '#scene/problem';
import { Reader } from '#scene/reader';
import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { hasTask } from '#simulation/task/task-brief';
import { isForOne, type Files } from './match-setup';
import { TOURNAMENT_FORMAT } from './format';
import { tournamentLimits } from './limits';
import { modes, type Draw, type Mode } from './play';
import { readToldStage, type ToldStage } from './read-told';
import { wholeCount, type Stage } from './stages';

const VERSION = 1;

/** Chosen: a class's programs are far shorter, and its matches some hundred. */
const limits = {
  /** As many as any file of JSON may have that is opened. */
  characters: 16 * 1024 * 1024,
  nameCharacters: 200,
  files: 20,
  fileCharacters: 262_144,
  seeds: { min: 1, max: 20 },
  seed: { min: 1, max: 1_000_000 },
  stages: { min: 0, max: 2 },
  ...tournamentLimits,
} as const;

/** Course, programs and kind of a tournament: with them it is played again. */
export interface Entry {
  /** The name of the course. */
  readonly name: string;
  readonly scene: Scene;
  /** Each with a name unlike the others'. */
  readonly programs: readonly { readonly name: string; readonly files: Files }[];
  readonly mode: Mode;
  readonly seeds: readonly number[];
}

/** The programs of a tournament and its mode, as it is played. */
export const drawOf = ({ scene, programs, mode, seeds }: Entry): Draw => ({
  ...{ mode, seeds, isAlone: isForOne(scene) },
  names: programs.map(({ name }) => name),
});

/** A tournament of a file: `told` is what the file says has come of it, for `differences`. */
export interface ToldTournament extends Entry {
  readonly told: readonly ToldStage[];
}

/** A stage for a file: its matches with the names of their programs, and the fingerprints of their runs. */
const dataOf = ({ mode, seeds, names, matches, table }: Stage): Readonly<Record<string, unknown>> => ({
  ...{ mode, seeds, names, table },
  matches: matches.map(({ a, b, ...match }) => ({ a: names[a], b: b === null ? null : names[b], ...match })),
});

/** The file of a tournament that was played. */
export function tournamentFile({ name, scene, programs, mode, seeds }: Entry, stages: readonly Stage[]): string {
  const list = (values: readonly unknown[]): string =>
    `[\n    ${values.map((value) => JSON.stringify(value)).join(',\n    ')}\n  ]`;
  const lines = [
    `"format": ${JSON.stringify(TOURNAMENT_FORMAT)}`,
    `"version": ${VERSION}`,
    `"name": ${JSON.stringify(name)}`,
    `"mode": ${JSON.stringify(mode)}`,
    `"seeds": ${JSON.stringify(seeds)}`,
    `"programs": ${list(programs)}`,
    `"stages": ${list(stages.map(dataOf))}`,
    `"course": ${serializeScene(scene).trimEnd().replaceAll('\n', '\n  ')}`,
  ];
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

/** A match that was played again, beside what a file tells of it. Only one of both may have it. */
export interface Compared {
  /** Place of its stage. */
  readonly stage: number;
  /** As it came out now, with the names of its programs; `undefined`: it was not played. */
  readonly now: unknown;
  /** As the file has it; `undefined`: it tells nothing. */
  readonly told: unknown;
  readonly isSame: boolean;
}

/** A tournament that was played again, compared with its file. */
export interface Comparison {
  /** Each match, in the order of the stages. */
  readonly matches: readonly Compared[];
  /** True if the tables are the file's. */
  readonly areTablesSame: boolean;
}

/** Compares a tournament that was played again with what its file tells. */
export function comparison(stages: readonly Stage[], told: readonly ToldStage[]): Comparison {
  const matches: Compared[] = [];
  let areTablesSame = true;
  for (let stage = 0; stage < Math.max(stages.length, told.length); stage++) {
    const [played, other] = [stages[stage], told[stage]];
    const here = played === undefined ? {} : dataOf(played);
    const [now, before] = [listIn(here), other?.matches ?? []];
    for (let match = 0; match < Math.max(now.length, before.length); match++)
      matches.push({ stage, now: now[match], told: before[match], isSame: isSame(now[match], before[match]) });
    areTablesSame &&= isSame(here['table'], other?.table);
  }
  return { matches, areTablesSame };
}

/** Number of matches that have come out otherwise than the file says; a table alone that differs counts as one. */
export function differences({ matches, areTablesSame }: Comparison): number {
  const count = matches.filter((one) => !one.isSame).length;
  return count === 0 && !areTablesSame ? 1 : count;
}

const listIn = ({ matches }: Readonly<Record<string, unknown>>): readonly unknown[] =>
  Array.isArray(matches) ? (matches as readonly unknown[]) : [];

/** Reads the file of a tournament. Never throws. */
export function parseTournament(text: string): { readonly tournament: ToldTournament } | { readonly problem: string } {
  const read = readJsonFile(text, 'tournament', limits.characters);
  if ('problem' in read) return { problem: read.problem.message };
  if (!isRecord(read.value) || read.value['format'] !== TOURNAMENT_FORMAT)
    return { problem: `This is not a tournament: "format" must be "${TOURNAMENT_FORMAT}".` };
  const { version } = read.value;
  if (version !== VERSION) return { problem: versionProblem('Tournament', version, VERSION).message };
  return readTournament(read.value);
}

function readTournament(value: unknown): ReturnType<typeof parseTournament> {
  const reader = new Reader();
  const fields = reader.fields(value, '', ['format', 'version', 'name', 'mode', 'seeds', 'programs', 'stages', 'course']); // prettier-ignore
  const name = reader.text(fields['name'], 'name', limits.nameCharacters, '');
  const mode = modes.find((one) => one === fields['mode']);
  if (mode === undefined) reader.report('unknown-value', 'mode', fields['mode'], `must be ${modes.join(' or ')}.`);
  const seeds = reader
    .list(fields['seeds'], 'seeds', limits.seeds)
    .map((seed, place) => reader.whole(seed, `seeds[${place}]`, limits.seed));
  const programs = reader
    .list(fields['programs'], 'programs', limits.programs)
    .map((program, place) => readProgram(program, `programs[${place}]`, reader));
  const told = reader
    .list(fields['stages'], 'stages', limits.stages)
    .map((stage, place) => readToldStage(stage, `stages[${place}]`, reader));
  if (new Set(programs.map((one) => one.name)).size < programs.length)
    reader.report('unknown-value', 'programs', undefined, 'two programs have the same name.');
  const [first] = reader.problems;
  if (first !== undefined || mode === undefined) return { problem: summaryOf(reader.problems) };
  const course = parseSceneValue(fields['course']);
  if ('problems' in course) return { problem: summaryOf(course.problems) };
  const tournament = { name, scene: course.scene, programs, mode, seeds, told };
  const problem = problemOf(tournament);
  return problem === null ? { tournament } : { problem };
}

/** Why a tournament cannot be played; `null`: it can. */
function problemOf(entry: Entry): string | null {
  const draw = drawOf(entry);
  const count = wholeCount(draw);
  if (!hasTask(entry.scene)) return 'The course has no task that anybody could win.';
  if (entry.scene.task.robots === 'together') return 'In this course the robots work together: nobody could win.';
  if (draw.isAlone && draw.mode === 'knockout') return 'In a course for one nobody meets: "mode" must be league.';
  if (!draw.isAlone && draw.names.length < 2) return 'One program has nobody to meet.';
  return count > limits.matches ? `${count} matches are too many, at most ${limits.matches}.` : null;
}

function readProgram(value: unknown, path: string, reader: Reader): Entry['programs'][number] {
  const fields = reader.fields(value, path, ['name', 'files']);
  const files = isRecord(fields['files']) ? Object.entries(fields['files']) : [];
  const { length: count } = files;
  if (count === 0) reader.report('unknown-value', `${path}.files`, fields['files'], 'there is no program.');
  if (count > limits.files) {
    const what = `${count} files are too many, at most ${limits.files}.`;
    reader.report('too-many', `${path}.files`, undefined, what, { count, max: limits.files });
  }
  return {
    name: reader.text(fields['name'], `${path}.name`, limits.nameCharacters),
    files: Object.fromEntries(
      files.map(([file, text]) => [file, reader.text(text, `${path}.files.${file}`, limits.fileCharacters)]),
    ),
  };
}
