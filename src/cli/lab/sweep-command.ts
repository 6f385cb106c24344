import { basename } from 'node:path';
import { sweepHtml } from '#lab/report/sweep-html';
import type { RunEnd } from '#lab/run-end';
import { progressText, runText, sumText } from '#lab/say';
import { readSweep, valuesOf, type Sweep } from '#lab/sweep';
import { sweepCsv, sweepJson, type SweepResult, type SweepRun } from '#lab/sweep-texts';
import { withValues, type Base } from '#lab/what';
import { hasTask } from '#simulation/task/task-brief';
import { outputProblem, type Output } from '../outputs';
import { chanceOf, DEFAULT_LIMIT_US, placed, preparedRun } from '../prepared-run';
import { readRunFiles } from '../read-files';
import { isAddress, shortened } from '../read-work';
import type { SetupAsked } from '../run-arguments';
import { CountProgress, refuse, writeReports } from '../results-out';
import { isInShard } from '../shard';
import { printable, type Terminal } from '../terminal';
import { makeRuns, type Wanted } from './make-runs';
import { folderSweep, RunsFolder } from './runs-folder';
import type { SweepOptions } from './sweep-arguments';

type Problem = { readonly problem: string };

/** A sweep that has run, with the name of its program. */
interface Swept extends SweepResult {
  readonly name: string;
}

/**
 * Carries out `parcours sweep`.
 *
 * @returns the exit code: 0 all runs are made, 2 bad usage or a bad file
 */
export async function sweep(options: SweepOptions, terminal: Terminal): Promise<0 | 2> {
  const { work, lang } = options;
  const found = work === null ? joined(options) : await runAll(work, options, terminal);
  if ('problem' in found) return refuse(found.problem, terminal);
  const problems = writeReports([
    ['--report', options.report, () => sweepHtml(found, found.name, lang)],
    ['--csv', options.csv, () => sweepCsv(found)],
  ]);
  if (options.json) terminal.line(sweepJson(found));
  else if (!options.quiet) {
    for (const run of found.runs) terminal.line(printable(runText(run, found.varied, lang)));
    terminal.line(sumText(found, lang));
  }
  for (const problem of problems) refuse(problem, terminal);
  return problems.length > 0 ? 2 : 0;
}

/** The output files that the options name. */
const outputsOf = ({ report, csv }: SweepOptions): readonly Output[] => [
  { option: '--report', path: report },
  { option: '--csv', path: csv },
];

/** The runs of a folder, without running anything. */
function joined(options: SweepOptions): Swept | Problem {
  const path = options.folder ?? '';
  const folder = RunsFolder.read(path);
  if ('problem' in folder) return folder;
  const unwritable = outputProblem(outputsOf(options), folder.files(), 'sweep');
  if (unwritable !== null) return { problem: unwritable };
  const { name, varied, count } = folder.sweep;
  const runs: SweepRun[] = [];
  let missing = 0;
  for (let place = 0; place < count; place++) {
    const run = folder.find(place);
    if (run === null) missing += 1;
    else runs.push(run);
  }
  if (missing === 0) return { name, varied: varied.map((one) => one.name), runs };
  return {
    problem: `${path}: ${missing} of ${count} runs have no result yet. Run their shards once more with --resume.`,
  };
}

/** The runs in which something varies. */
interface Prepared {
  readonly base: Base;
  readonly sweep: Sweep;
  readonly end: RunEnd;
  /** Files that were read. */
  readonly files: readonly string[];
  /** Puts the name of the file before a problem of the whole set-up. */
  readonly placed: (problem: string) => string;
}

async function prepare(
  { run, vary }: NonNullable<SweepOptions['work']>,
  terminal: Terminal,
): Promise<Prepared | Problem> {
  const read = await readRunFiles(run);
  if ('problem' in read) return read;
  const prepared = preparedRun(run, read);
  if ('problem' in prepared) return prepared;
  const { setup, options } = prepared;
  const base: Base = {
    setup,
    usedSeed: chanceOf({ ...options, reality: 1 }, read.settings).seed,
    idealSeed: chanceOf({ ...options, reality: 0 }, read.settings).seed,
    ...(!isAddress(run.program) && { mainName: basename(run.program) }),
  };
  const found = readSweep(vary, base);
  if ('problem' in found) return { problem: found.problem.replaceAll(/^/gm, '--vary ') };
  for (const note of read.notes) terminal.message(`parcours: ${note}`);
  const { forUs } = run;
  const isTask = hasTask(setup.scene);
  return {
    base,
    sweep: found,
    end: {
      untilUs: forUs ?? DEFAULT_LIMIT_US,
      untilProgramEnds: forUs === null && !isTask,
      untilVerdict: forUs === null && isTask,
    },
    files: filesOf(run),
    placed: (problem) => placed(problem, options, (setup.inputs?.length ?? 0) - read.inputs.length),
  };
}

const filesOf = ({ program, files, devices, scene, input, myRobot }: SetupAsked): readonly string[] =>
  [program, ...files, ...devices.flatMap((one) => [one.program, ...one.files]), scene, input, myRobot].filter(
    (name) => name !== null,
  );

/** Runs what is missing. */
async function runAll(
  work: NonNullable<SweepOptions['work']>,
  options: SweepOptions,
  terminal: Terminal,
): Promise<Swept | Problem> {
  const prepared = await prepare(work, terminal);
  if ('problem' in prepared) return prepared;
  const { base, sweep: asked, end } = prepared;
  const { folder: path } = options;
  const list = { option: '--resume', path: path && RunsFolder.sweepIn(path), isInNewFolder: true } as const;
  const unwritable = outputProblem([...outputsOf(options), list], prepared.files, 'sweep');
  if (unwritable !== null) return { problem: unwritable };
  const name = isAddress(work.run.program) ? shortened(work.run.program) : basename(work.run.program);
  const folder = path === null ? null : RunsFolder.open(path, folderSweep(name, asked, base, end));
  if (folder !== null && 'problem' in folder) return { problem: `--resume: ${folder.problem}` };
  const places = Array.from({ length: asked.count }, (_, place) => place).filter((at) => isInShard(work.shard, at));
  const runs = new Map<number, SweepRun>();
  for (const place of places) {
    const kept = folder?.find(place) ?? null;
    if (kept !== null) runs.set(place, kept);
  }
  const progress = new CountProgress(terminal, places.length, options.quiet || options.json, (done) =>
    progressText(done, places.length, options.lang),
  );
  progress.add(runs.size);
  const missing = places.filter((place) => !runs.has(place));
  const refused = await makeRuns(
    wanted(missing, prepared),
    Math.min(work.jobs, missing.length),
    (place, { outcome }) => {
      const run = { values: valuesOf(asked, place), ...outcome };
      runs.set(place, run);
      folder?.keep(place, run);
      progress.add(1);
    },
  );
  terminal.clearProgress();
  if (refused !== null) return { problem: `${namedValues(asked, refused.is)}: ${prepared.placed(refused.problem)}` };
  const inOrder = places.flatMap((place) => runs.get(place) ?? []);
  return { name, varied: asked.varied.map((one) => one.name), runs: inOrder };
}

function* wanted(places: readonly number[], { base, sweep: asked, end }: Prepared): Generator<Wanted<number>> {
  for (const place of places)
    yield { is: place, request: { setup: withValues(base, asked.varied, valuesOf(asked, place)), end } };
}

const namedValues = (asked: Sweep, place: number): string =>
  valuesOf(asked, place)
    .map((value, index) => `${asked.varied[index]?.name ?? ''}=${value}`)
    .join(', ');
