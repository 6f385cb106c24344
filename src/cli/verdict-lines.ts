import type { Language, Texts } from '#core/languages';
import { filledIn } from '#core/words';
import type { Points } from '#rescue-line/points';
import { pointRules } from '#rescue-line/rules';
import type { RobotVerdict, Verdict } from '#simulation/task/verdict';
import words from './words';

const { why, robots, points, ...said } = words.verdict;

/** Goals reached; blocks are left out for one of several robots, as all robots share them. */
type Progress = Pick<Verdict, 'checkpoints' | 'targets'> & Partial<Pick<Verdict, 'blocks'>>;

/** Writes a text of the catalogue in the reader's language. */
type Say = (texts: Texts, values?: Readonly<Record<string, string | number>>) => string;

/** The result of the course's task, as lines for people, one more for each robot that shares it; none without a task. */
export function verdictLines(verdict: Verdict | null, language: Language): readonly string[] {
  if (verdict === null) return [];
  const say: Say = (texts, values = {}) => filledIn(texts[language], values);
  return [
    verdictLine(verdict, say),
    ...verdict.robots.map((robot) => `  ${robot.device}: ${robotWords(robot, say)}`),
    ...(verdict.points === undefined ? [] : pointLines(verdict.points, say)),
  ];
}

/** The score sheet of a line: the sum, and what has brought points or still may. */
function pointLines({ rules, score, lacks, section, attempt, factor, lines }: Points, say: Say): readonly string[] {
  const { name, year } = pointRules[rules];
  const sum = say(points.sum, { score, name, year, lacks, section, attempt });
  const all = lines.map(({ what, tile, count, points: worth, state }) =>
    say(points[state], { what: say(points.what[what], { count, tile: tile + 1 }), points: worth }),
  );
  const victims = factor === undefined ? [] : [say(points.factor, { factor: Math.round(factor * 1000) / 1000 })];
  return [sum, ...[...all, ...victims].map((line) => `  ${line}`)];
}

const secondsOf = (atMs: number | null): string => `${((atMs ?? 0) / 1000).toFixed(1)} s`;

function verdictLine(verdict: Verdict, say: Say): string {
  const { state, atMs, stars } = verdict;
  return say(said[state], {
    time: secondsOf(atMs),
    help: verdict.help.map((one) => say(said[one])).join(''),
    stars: stars === null ? '' : say(said.stars, { stars }),
    why: state === 'failed' ? failureWords(verdict, say) : '',
    progress: progressWords(verdict, say),
    early: earlyWords(verdict, say),
  });
}

function robotWords(robot: RobotVerdict, say: Say): string {
  const { state, atMs } = robot;
  const time = secondsOf(atMs);
  if (state === 'passed') return say(robots.passed, { time });
  if (state === 'open') return say(robots.open, { progress: progressWords(robot, say) });
  return say(robots.failed, { time, why: robotFailureWords(robot, say) });
}

function robotFailureWords({ reason, ...robot }: RobotVerdict, say: Say): string {
  if (reason === 'caught' || reason === 'beaten') return say(why[reason]);
  if (reason === 'left') return say(why.ownLeft);
  return failureWords({ ...robot, reason, early: null }, say);
}

function failureWords(verdict: Progress & Pick<Verdict, 'reason' | 'by' | 'early'>, say: Say): string {
  const { reason, by } = verdict;
  if (reason === null) return ''; // nothing fails so
  if (reason === 'touched' && by === null) return say(why.edge);
  const so = { progress: progressWords(verdict, say), early: earlyWords(verdict, say) };
  return say(why[reason], { by: by ?? '', ...so });
}

/** `; checkpoint 2 came before checkpoint 1`, or nothing if all were in their order. */
function earlyWords({ early }: Pick<Verdict, 'early'>, say: Say): string {
  if (early === null) return '';
  return say(early.number === 0 ? said.earlyTarget : said.early, { number: early.number, before: early.before });
}

/** ` (1 of 3 checkpoints, 0 of 1 target)`, or nothing if there is nothing to reach. */
function progressWords({ checkpoints, targets, blocks = { delivered: 0, of: 0 } }: Progress, say: Say): string {
  const counted = (done: number, of: number, one: Texts, many: Texts): readonly string[] =>
    of === 0 ? [] : [say(of === 1 ? one : many, { done, of })];
  const parts = [
    ...counted(checkpoints.passed, checkpoints.of, said.checkpoint, said.checkpoints),
    ...counted(targets.reached, targets.of, said.target, said.targets),
    ...counted(blocks.delivered, blocks.of, said.block, said.blocks),
  ];
  return parts.length > 0 ? ` (${parts.join(', ')})` : '';
}
