import { csvText } from '#core/csv';
import type { Language } from '#core/languages';

import type { CheckResult } from '../result';
import { mostPoints, type ClassTask } from '../task/task';
import { passedOf, type ClassResult } from './class-result';
import { escaped } from './escaped';
import { reasonText, remarkText } from './say';
import reportWords from './words';

/** A group of hand-ins for other programs. */
export interface NamedGroup {
  readonly key: string;
  readonly title: string;
  readonly fact: string;
  /** Names of its hand-ins. */
  readonly members: readonly string[];
}

/**
 * The result of a class as one line of JSON, without wall times: equal work gives equal text.
 * `schemas/check-result.schema.json` describes it.
 *
 * @param language of the sentences in `reason` and `remarks`
 * @param groups left out: none were asked for
 */
export function jsonOf(
  found: ClassResult,
  asked: ClassTask,
  language: Language,
  groups?: readonly NamedGroup[],
): string {
  const groupOf = new Map(groups?.flatMap(({ key, members }) => members.map((name) => [name, key] as const)));
  const { task, handIns } = found;
  const pointsOf = (id: string): number => asked.checks.find((check) => check.id === id)?.points ?? 0;
  return JSON.stringify({
    task,
    maxPoints: mostPoints(asked),
    handIns: handIns.map(({ name, result }) => {
      const { passed, points, stars, checks, worlds, remarks } = result;
      return {
        ...{ name, passed, points: isUnread(result) ? null : points },
        ...(stars !== null && { stars }),
        checks: checks.map((check) => ({
          ...{ id: check.id, passed: check.passed, points: pointsOf(check.id) },
          reason: check.reason && reasonText(check.reason, language),
        })),
        worlds: worlds.map((world) => ({
          ...{ id: world.id, hidden: world.hidden, passed: world.passed },
          reason: world.reason && reasonText(world.reason, language),
          ...{ atMs: world.atMs, touches: world.touches },
        })),
        remarks: remarks.map((remark) => remarkText(remark, language)),
        ...(groups && { group: groupOf.get(name) ?? null }),
      };
    }),
    passed: passedOf(found),
    of: handIns.length,
    ...(groups && {
      groups: groups.map(({ key, title, fact, members }) => ({ key, title, fact, count: members.length })),
    }),
  });
}

/** A simulated time as people read it. */
export const secondsText = (ms: number): string => `${(ms / 1000).toFixed(1)} s`;

/** All reasons against a hand-in, each sentence once. */
export function reasonsAgainst({ checks, worlds }: CheckResult, language: Language): readonly string[] {
  const reasons = [...worlds.map(({ reason }) => reason), ...checks.map(({ reason }) => reason)];
  return [...new Set(reasons.flatMap((reason) => (reason === null ? [] : [reasonText(reason, language)])))];
}

/** The result of a class as a table for programs, a row for each hand-in, notes where there are some; RFC 4180. */
export function csvOf({ handIns }: ClassResult, language: Language): string {
  const words = reportWords.report;
  const say = (name: keyof typeof words): string => words[name][language];
  const [worlds, checks] = [idsOf(handIns.map(({ result }) => result.worlds)), idsOf(handIns.map(({ result }) => result.checks))]; // prettier-ignore
  const hasNotes = handIns.some(({ note = '' }) => note !== '');
  const headings = [
    ...[say('name'), say('passed'), say('points'), say('stars')],
    ...checks,
    ...worlds.flatMap((id) => [`${id}: ${say('passed')}`, `${id}: ms`, `${id}: ${say('touches')}`]),
    ...[say('missed'), say('remarks')],
    ...(hasNotes ? [say('note')] : []),
  ];
  const rows = handIns.map(({ name, result, note = '' }) => [
    // A hand-in that could not be read has no points.
    ...(isUnread(result)
      ? [name, '', '', '']
      : [name, yes(result.passed), String(result.points), String(result.stars ?? '')]),
    ...checks.map((id) =>
      isUnread(result) ? '' : yes(result.checks.find((check) => check.id === id)?.passed ?? false),
    ),
    ...worlds.flatMap((id) => {
      const world = result.worlds.find((one) => one.id === id);
      return world === undefined ? ['', '', ''] : [yes(world.passed), String(world.atMs ?? ''), String(world.touches)];
    }),
    result.passed ? '' : reasonsAgainst(result, language).join(' · '),
    result.remarks.map((remark) => remarkText(remark, language)).join(' · '),
    ...(hasNotes ? [note] : []),
  ]);
  return csvText([headings, ...rows]);
}

const yes = (is: boolean): string => (is ? '1' : '0');

const idsOf = (lists: readonly (readonly { readonly id: string }[])[]): readonly string[] => [
  ...new Set(lists.flat().map(({ id }) => id)),
];

/** The result of a class as JUnit's XML: a test case for each hand-in, its simulated time as time. */
export function junitOf(found: ClassResult, language: Language): string {
  const { task, handIns } = found;
  const errors = handIns.filter(({ result }) => isUnread(result)).length;
  const failures = handIns.length - passedOf(found) - errors;
  const counts = `tests="${handIns.length}" failures="${failures}" errors="${errors}"`;
  const cases = handIns.map(({ name, result }) => {
    const seconds = result.worlds.reduce((sum, { atMs }) => sum + (atMs ?? 0), 0) / 1000;
    const open = `    <testcase classname="${escaped(task)}" name="${escaped(name)}" time="${seconds}"`;
    if (result.passed) return `${open}/>\n`;
    const said = [...reasonsAgainst(result, language), ...result.remarks.map((one) => remarkText(one, language))];
    const kind = isUnread(result) ? 'error' : 'failure';
    return `${open}>\n      <${kind} message="${escaped(said[0] ?? '')}">${escaped(said.join('\n'))}</${kind}>\n    </testcase>\n`;
  });
  return `<?xml version="1.0" encoding="UTF-8"?>\n<testsuites ${counts}>\n  <testsuite name="${escaped(task)}" ${counts}>\n${cases.join('')}  </testsuite>\n</testsuites>\n`;
}

/** True if the hand-in could not be read. */
export const isUnread = ({ remarks }: CheckResult): boolean => remarks.some(({ code }) => code === 'unreadable');
