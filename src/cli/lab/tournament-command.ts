import { resolve } from 'node:path';
import { progressText } from '#lab/say';
import { isForOne, type Files } from '#lab/tournament/match-setup';
import { programNames } from '#lab/tournament/names';
import { matchCount, played, type Draw, type Tournament } from '#lab/tournament/play';
import { firstStage } from '#lab/tournament/stages';
import { playedText, rowText, tournamentCsv, tournamentHtml, tournamentJson } from '#lab/tournament/texts';
import { MOST_RUNS } from '#lab/values';
import type { Scene } from '#scene/scene';
import { hasTask } from '#simulation/task/task-brief';
import { outputProblem } from '../outputs';
import { filesOfWord, readCourse } from '../read-files';
import { isAddress, shortened } from '../read-work';
import { CountProgress, refuse, writeReports } from '../results-out';
import { printable, type Terminal } from '../terminal';
import { matchPlayer } from './play-matches';
import type { PlayOptions, TournamentOptions } from './tournament-arguments';
import { verifyTournament } from './verify-tournament';

type Problem = { readonly problem: string };

/** Course and programs, read. */
interface Entered {
  readonly scene: Scene;
  /** Remarks on the course. */
  readonly notes: readonly string[];
  readonly programs: readonly Files[];
  readonly draw: Draw;
}

/**
 * Carries out `parcours tournament`.
 *
 * @returns the exit code: 0 all matches are played, 1 one is not as the file says that is verified, 2 bad usage or a bad file
 */
export async function tournament(options: TournamentOptions, terminal: Terminal): Promise<0 | 1 | 2> {
  if ('verify' in options) return verifyTournament(options, terminal);
  const entered = await enter(options);
  if ('problem' in entered) return refuse(entered.problem, terminal);
  for (const note of entered.notes) terminal.message(`parcours: ${note}`);
  const found = await playAll(entered, options, terminal);
  if ('problem' in found) return refuse(found.problem, terminal);
  const { lang, course } = options;
  const problems = writeReports([
    ['--report', options.report, () => tournamentHtml(found, entered.scene.name || shortened(course), lang)],
    ['--csv', options.csv, () => tournamentCsv(found)],
  ]);
  if (options.json) terminal.line(tournamentJson(found));
  else if (!options.quiet) {
    for (const [place, row] of found.table.entries()) terminal.line(printable(rowText(row, place)));
    terminal.line(playedText(found.matches.length, lang));
  }
  for (const problem of problems) refuse(problem, terminal);
  return problems.length > 0 ? 2 : 0;
}

/** Reads everything, and says what is wrong with it before a match is played. */
async function enter({ course, programs: paths, mode, seeds, report, csv }: PlayOptions): Promise<Entered | Problem> {
  const read = await readCourse(course);
  if ('problem' in read) return read;
  const { scene, notes } = read;
  if (!hasTask(scene)) return { problem: `${shortened(course)}: the course has no task that anybody could win.` };
  const programs: Files[] = [];
  for (const path of paths) {
    const work = await filesOfWord(path);
    if ('problem' in work) return work;
    programs.push(work.files);
  }
  const outputs = [
    { option: '--report', path: report },
    { option: '--csv', path: csv },
  ];
  const unwritable = outputProblem(outputs, [course, ...paths], 'tournament');
  if (unwritable !== null) return { problem: unwritable };
  const names = programNames(
    paths.map((path) => (isAddress(path) ? shortened(path) : resolve(path).replaceAll('\\', '/'))),
  );
  const draw: Draw = { mode, names, seeds, isAlone: isForOne(scene) };
  const problem = drawProblem(draw, course);
  return problem === null ? { scene, notes, programs, draw } : { problem };
}

function drawProblem(draw: Draw, course: string): string | null {
  if (draw.isAlone && draw.mode === 'knockout')
    return `--mode knockout: ${shortened(course)} is a course for one robot, in which nobody meets. Leave it out.`;
  if (!draw.isAlone && draw.names.length < 2) return 'One program has nobody to meet. Name another one.';
  const count = matchCount(draw);
  return count > MOST_RUNS ? `${count} matches are too many, at most ${MOST_RUNS}.` : null;
}

async function playAll(
  { scene, programs, draw }: Entered,
  { jobs, quiet, json, lang }: PlayOptions,
  terminal: Terminal,
): Promise<Tournament | Problem> {
  const of = matchCount(draw);
  const progress = new CountProgress(terminal, of, quiet || json, (done) => progressText(done, of, lang));
  const named = programs.map((files, place) => ({ name: draw.names[place] ?? '', files }));
  const player = await matchPlayer({ scene, programs: named }, Math.min(jobs, of), () => progress.add(1));
  const found = await played(draw, (pairings) => player.play(firstStage(draw), pairings));
  player.stop();
  terminal.clearProgress();
  return found ?? { problem: player.problem };
}
