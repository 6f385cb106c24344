import { equalWorlds } from '#check/equal-worlds';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { contentOf, type Source } from '#intake/sources';
import { inLanes, Lane, type StartThread } from '#check/lane';
import { classResult, passedOf, type ClassResult, type NamedResult } from '#check/report/class-result';
import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import { groupsHtmlOf } from '#check/report/groups-html';
import { htmlOf } from '#check/report/html';
import { csvOf, isUnread, jsonOf, junitOf, reasonsAgainst, secondsText } from '#check/report/texts';
import { tableOf } from '#check/report/table';
import { equalTexts, otherTaskTexts, remarkBeside } from '#check/report/say';
import { unreadable, type CheckResult } from '#check/result';
import { hiddenWorlds, type ClassTask } from '#check/task/task';
import type { Group } from '#hint/groups/groups';
import { readFirmware } from '../firmware';
import { outputProblem, type Output } from '../outputs';
import { CountProgress, refuse, writeReports } from '../results-out';
import { printable, type Terminal } from '../terminal';
import type { CheckOptions } from './check-arguments';
import { startThread } from './pool';
import { groupSaid, groupsIn, lookAtAll, reportGroups, type Looks } from './groups';
import { readTask, titleOf, type NamedTask } from './read-task';
import { ResultsFolder } from './results-folder';
import { isInShard } from '../shard';
import { every } from '../threads/threads';
import { findHandIns } from './sources';
import { howToTake, withTaken } from './take';
import words from './words';

/** Results in the order of the hand-ins, with their task. */
interface Checked extends NamedTask {
  readonly results: readonly NamedResult[];
  /** Facts about the runs; left out: no groups are wanted. */
  readonly looks?: Looks;
}

type Problem = { readonly problem: string };

/**
 * Carries out `parcours check`.
 *
 * @returns the exit code: 0 all hand-ins have passed, 3 some have not, 2 bad usage
 */
export async function checkHandIns(options: CheckOptions, terminal: Terminal): Promise<0 | 2 | 3> {
  const { work } = options;
  const checked = work === null ? joined(options) : await runAll(work, options, terminal);
  if ('problem' in checked) return refuse(checked.problem, terminal);
  const found = classResult(checked.name, checked.results, options.lang);
  const groups = checked.looks === undefined ? null : groupsIn(found, checked.task, checked.looks);
  const problems = writeAll(found, checked, groups, options);
  const [passed, of] = [passedOf(found), found.handIns.length];
  if (options.json)
    terminal.line(jsonOf(found, checked.task, options.lang, groups?.map((group) => jsonGroup(group, checked, options)))); // prettier-ignore
  else if (!options.quiet) {
    for (const group of groups ?? []) terminal.line(printable(groupLine(group, checked, options)));
    for (const one of groups === null ? found.handIns : []) terminal.line(lineOf(one, options));
    terminal.line(printable(filledIn(words.sum[options.lang], { name: checked.name, passed, of })));
  }
  const how = howToTake(found.handIns, options.lang);
  const notes = [...otherTaskTexts(found, options.lang), ...(how === null ? [] : [how])];
  if (!options.quiet) for (const text of notes) terminal.message(`parcours: ${text}`);
  for (const problem of problems) refuse(problem, terminal);
  return problems.length > 0 ? 2 : passed === of ? 0 : 3;
}

function groupLine(group: Group, { task }: Checked, { lang }: CheckOptions): string {
  const { title, fact } = groupSaid(group, task, lang);
  return fact === '' ? title : `${title}: ${fact}`;
}

const jsonGroup = (group: Group, { task }: Checked, { lang }: CheckOptions) => ({
  ...{ key: group.key, ...groupSaid(group, task, lang), members: group.members },
});

/** The output files that the options name. */
const outputsOf = ({ report, junit, csv, table }: CheckOptions): readonly Output[] => [
  { option: '--report', path: report },
  { option: '--junit', path: junit },
  { option: '--csv', path: csv },
  { option: '--table', path: table },
];

/** The results of a folder, without running anything. */
function joined(options: CheckOptions): Checked | Problem {
  const { folder } = options;
  const read = ResultsFolder.read(folder ?? '');
  if ('problem' in read) return read;
  const unwritable = outputProblem(outputsOf(options), read.folder.files(), 'check');
  if (unwritable !== null) return { problem: unwritable };
  const { names, ...named } = read.contents;
  const results: NamedResult[] = [];
  const missing: string[] = [];
  for (const one of names) {
    const result = read.folder.latest(one);
    if (result === null) missing.push(one);
    else results.push({ name: one, result });
  }
  if (missing.length === 0) return { ...named, results };
  const some = missing.slice(0, 5).join(', ') + (missing.length > 5 ? ', …' : '');
  return {
    problem: `${folder ?? ''}: ${missing.length} of ${names.length} hand-ins have no result yet: ${some}. Run their shards once more with --resume.`,
  };
}

/** Runs what is missing. */
async function runAll(
  work: NonNullable<CheckOptions['work']>,
  options: CheckOptions,
  terminal: Terminal,
): Promise<Checked | Problem> {
  const { folder: path, report, quiet, json } = options;
  const firmware = WebAssembly.compile(readFirmware()); // meanwhile the task and the hand-ins are read
  const read = await readTask(work.task);
  if ('problem' in read) return read;
  const { task } = read;
  const found = await findHandIns(work.handIns);
  if ('problem' in found) return found;
  if (found.sources.length === 0) return { problem: `${work.handIns.join(', ')}: there are no hand-ins.` };
  const list = { option: '--resume', path: path && ResultsFolder.listIn(path), isInNewFolder: true } as const;
  const unwritable = outputProblem([...outputsOf(options), list], [...read.files, ...found.files], 'check');
  if (unwritable !== null) return { problem: unwritable };
  const sources = withTaken(found.sources, work.take);
  if ('problem' in sources) return sources;
  const names = sources.map((source) => source.name);
  const folder = path === null ? null : ResultsFolder.open(path, { ...read, names });
  if (folder !== null && 'problem' in folder) return { problem: `--resume: ${folder.problem}` };
  const mine = sources.filter((_, place) => isInShard(work.shard, place));
  const progress = new Progress(terminal, mine.length, quiet || json, options.lang);
  const start = startThread(task, await firmware);
  let equal: readonly string[] = [];
  const lookForEqual = async (lane: Lane): Promise<void> => {
    equal = await equalIn(task, lane, options.lang);
  };
  const running = { jobs: work.jobs, folder, keepsWays: report !== null || options.groups, progress };
  const results = await checkAll(task, mine, start, { ...running, ...(!quiet && { last: lookForEqual }) });
  const looks = options.groups ? await lookAtAll(task, results, { sources: mine, firmware: await firmware, jobs: work.jobs }) : undefined; // prettier-ignore
  terminal.clearProgress();
  for (const text of equal) terminal.message(`parcours: ${text}`);
  return { ...read, results, ...(looks && { looks }) };
}

/** Shows the progress of hand-ins, and how many of them have passed. */
export class Progress {
  private readonly count: CountProgress;
  private passed = 0;

  constructor(terminal: Terminal, of: number, isQuiet: boolean, language: Language) {
    this.count = new CountProgress(terminal, of, isQuiet, (done) =>
      filledIn(words.progress[language], { done, of, passed: this.passed }),
    );
  }

  add({ passed }: CheckResult): void {
    if (passed) this.passed += 1;
    this.count.add(1);
  }
}

interface Running {
  readonly jobs: number;
  readonly folder: ResultsFolder | null;
  /** True if the robots' trails are stored: only reports draw them, and ten thousand would fill the memory. */
  readonly keepsWays: boolean;
  readonly progress: Progress;
  /** Begun when all hand-ins are taken, in the first thread that is free: it has warmed up. */
  readonly last?: (lane: Lane) => Promise<void>;
}

/** Checks all hand-ins. The results do not depend on the lane that has checked each. */
export async function checkAll(
  task: ClassTask,
  sources: readonly Source[],
  start: StartThread,
  running: Running,
): Promise<readonly NamedResult[]> {
  const { jobs, keepsWays, progress, last } = running;
  const results: NamedResult[] = [];
  const lanes = Array.from({ length: Math.min(jobs, sources.length) }, () => new Lane(task, start, every));
  const works = sources.map((source, place) => async (lane: Lane): Promise<void> => {
    const result = await resultOf(task, source, lane, running);
    results[place] = { name: source.name, result: keepsWays ? result : withoutWays(result) };
    progress.add(result);
  });
  await inLanes(last === undefined ? works : [...works, last], lanes, (work, _, lane) => work(lane));
  return results;
}

/** Remarks on hidden worlds that test nothing new, found with the task's model solution. */
async function equalIn(task: ClassTask, lane: Lane, language: Language): Promise<readonly string[]> {
  if (task.solution === null || hiddenWorlds(task).length === 0) return [];
  const result = await lane.check(handInOfFiles(task.solution));
  return equalTexts(equalWorlds(task, result), language);
}

const withoutWays = (result: CheckResult): CheckResult => ({
  ...result,
  worlds: result.worlds.map((world) => ({ ...world, trail: [], trailMs: [] })),
});

async function resultOf(task: ClassTask, source: Source, lane: Lane, { folder }: Running): Promise<CheckResult> {
  const content = await contentOf(source);
  const key = folder?.keyFor(content) ?? '';
  const kept = folder?.find(source.name, key) ?? null;
  if (kept !== null) return kept;
  const result = 'problem' in content ? unreadable(task.checks, content.problem) : await lane.check(content.handIn);
  folder?.keep(source.name, key, result);
  return result;
}

/** Writes all that can be written. @returns the problems with the others */
function writeAll(
  found: ClassResult,
  named: NamedTask,
  groups: readonly Group[] | null,
  options: CheckOptions,
): readonly string[] {
  // prettier-ignore
  const { task } = named;
  const { report, junit, csv, table, form, lang } = options;
  return writeReports([
    [
      '--report',
      report,
      () => {
        const titled = { ...found, task: titleOf(named, lang) };
        return groups === null ? htmlOf(titled, task, lang) : groupsHtmlOf(titled, task, lang, reportGroups(groups, found, task, lang)); // prettier-ignore
      },
    ],
    ['--junit', junit, () => junitOf(found, lang)],
    // Spreadsheets take a file for UTF-8 only if it begins with this sign.
    ['--csv', csv, () => `\ufeff${csvOf(found, lang)}`],
    ['--table', table, () => tableOf(found, task, lang, { form })],
  ]);
}

function lineOf({ name, shown = name, result }: NamedResult, { lang }: CheckOptions): string {
  const { passed, points, worlds, remarks } = result;
  const word = words[isUnread(result) ? 'unread' : passed ? 'passed' : 'failed'][lang];
  const time = worlds[0]?.atMs ?? null;
  const told = [
    ...(time === null ? [] : [secondsText(time)]),
    ...(passed ? [] : reasonsAgainst(result, lang)),
    ...remarks.map((remark) => remarkBeside(remark, lang)),
  ];
  const figures = isUnread(result) ? [word, shown] : [word, shown, points];
  // What a program's error says stays in its line.
  return printable([...figures, told.join(' · ')].join('  ').trimEnd().replaceAll('\n', ' '));
}
