import type { Scene } from '#scene/scene';
import { isSpiked } from '#simulation/kinds';
import { briefOf } from '#simulation/task/task-brief';
import type { Verdict } from '#simulation/task/verdict';

/** Name of the sentence for a goal. */
export type GoalWords =
  | 'checkpoint'
  | 'checkpointsInOrder'
  | 'checkpointsAny'
  | 'target'
  | 'targets'
  | 'thenTarget'
  | 'thenTargets'
  | 'block'
  | 'blocks'
  | 'ring'
  | 'catch'
  | 'line'
  | 'holdOut';

/** A goal, in words made from the course, and the progress towards it. */
export interface TaskGoal {
  readonly words: GoalWords;
  readonly values: Readonly<Record<string, number>>;
  readonly done: number;
  readonly of: number;
}

/** A rule of the task, in words. `isBroken`: it is the reason why the task was failed, or did not count. */
export interface TaskRule {
  readonly words:
    | 'all'
    | 'first'
    | 'together'
    | 'seconds'
    | 'noTouch'
    | 'forbidden'
    | 'spikes'
    | 'ownHands'
    | 'handMayHelp'
    | 'editsMayHelp';
  readonly values: Readonly<Record<string, number>>;
  readonly isBroken: boolean;
}

type Course = Pick<Scene, 'task' | 'objects' | 'league'>;

/** The goals, in the order in which they are reached. */
export function goalsInWords(course: Course, verdict: Verdict | null): readonly TaskGoal[] {
  const { checkpoints, robotTargets, blocksWanted, task } = briefOf(course);
  const goals: TaskGoal[] = [];
  const numbers = checkpoints.map(({ number }) => number);
  const [first = 0] = numbers;
  const last = numbers.at(-1) ?? 0;
  const count = numbers.length;
  if (count > 0) {
    const words = count === 1 ? 'checkpoint' : first === last ? 'checkpointsAny' : 'checkpointsInOrder';
    goals.push({
      words,
      values: { first, last, count },
      done: verdict?.checkpoints.passed ?? 0,
      of: verdict?.checkpoints.of ?? count,
    });
  }
  // What is pushed comes first: the robot has driven on to its own target when all is done.
  if (blocksWanted > 0) {
    const words = blocksWanted === 1 ? 'block' : 'blocks';
    goals.push({ words, values: { count: blocksWanted }, done: verdict?.blocks.delivered ?? 0, of: blocksWanted });
  }
  const targets = robotTargets.length;
  if (targets > 0) {
    const words = count > 0 ? (targets === 1 ? 'thenTarget' : 'thenTargets') : targets === 1 ? 'target' : 'targets';
    goals.push({
      words,
      values: { count: targets },
      done: verdict?.targets.reached ?? 0,
      of: verdict?.targets.of ?? targets,
    });
  }
  const done = verdict?.state === 'passed' || verdict?.state === 'helped' ? 1 : 0;
  if (task.robots === 'ring' || task.robots === 'catch') goals.push({ words: task.robots, values: {}, done, of: 1 });
  if (course.league !== undefined) goals.push({ words: 'line', values: {}, done, of: 1 });
  if (goals.length === 0 && task.seconds !== null)
    goals.push({ words: 'holdOut', values: { seconds: task.seconds }, done, of: 1 });
  return goals;
}

/** The rules, and the help that is allowed. */
export function rulesInWords(course: Course, verdict: Verdict | null): readonly TaskRule[] {
  const { task, objects } = course;
  const goals = goalsInWords(course, null);
  const why = verdict?.state === 'failed' ? verdict.reason : null;
  const help = verdict?.state === 'helped' ? verdict.help : [];
  const rules: TaskRule[] = [];
  const add = (words: TaskRule['words'], isBroken = false, values: TaskRule['values'] = {}): void =>
    void rules.push({ words, values, isBroken });
  if (task.robots === 'all' || task.robots === 'first' || task.robots === 'together') add(task.robots);
  if (task.seconds !== null && goals[0]?.words !== 'holdOut') add('seconds', why === 'time', { seconds: task.seconds });
  if (task.noTouch) add('noTouch', why === 'touched' || why === 'robot' || why === 'spikes');
  if (objects.some(({ type }) => type === 'forbidden')) add('forbidden', why === 'forbidden');
  if (!task.noTouch && objects.some(isSpiked)) add('spikes', why === 'spikes');
  if (goals.length === 0) return rules;
  if (task.allows?.includes('hand') === true) add('handMayHelp');
  else add('ownHands', help.includes('hand'));
  if (task.allows?.includes('edits') === true) add('editsMayHelp');
  return rules;
}
