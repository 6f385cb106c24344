import type { ClassResult } from '#check/report/class-result';
import { unread } from '#check/hand-in/unread';
import { unreadable, type CheckResult } from '#check/result';
import { noLocks, plainWorld, type Check, type ClassTask } from '#check/task/task';
import { defaultScene } from '#scene/scene';

const checks: readonly Check[] = [
  { id: 'goals', type: 'goals', points: 2, needed: true },
  { id: 'loop', type: 'loop', points: 1, needed: false },
  { id: 'touches', type: 'touches', most: 0, points: 1, needed: true },
];

/** A task of four points with this id. */
export const aTask = (id: string): ClassTask => ({
  ...{ id, checks, least: null, seconds: null, stars: null, solution: null, locks: noLocks },
  project: { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null },
  worlds: [plainWorld],
});

/** A result of so many points; four are a pass, `null` could not be read. */
export const aResult = (points: number | null, twin = `work ${String(points)}`): CheckResult =>
  points === null
    ? unreadable(checks, unread('kind').problem)
    : { passed: points === 4, points, stars: null, checks: [], worlds: [], remarks: [], twin };

/** The results of a task by the names on the hand-ins. */
export const found = (task: string, results: Readonly<Record<string, CheckResult>>): ClassResult => ({
  task,
  handIns: Object.entries(results).map(([name, result]) => ({ name, result })),
});
