import { Asker, inLanes, longestMs } from '#check/lane';
import type { ClassResult, NamedResult } from '#check/report/class-result';
import type { ReportGroup } from '#check/report/groups-html';
import type { Reason } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { projectOfTask } from '#check/task/write-task';
import type { Language } from '#core/languages';
import { groupsOf, type Group } from '#hint/groups/groups';
import type { RunFacts } from '#hint/groups/run-facts';
import { groupFact, groupSign, groupTitle, saidToClass } from '#hint/groups/say';
import { contentOf, type Source } from '#intake/sources';
import { every, threads } from '../threads/threads';
import type { FactsRequest } from './facts-worker';
import type { CheckerData } from './pool-messages';

/** Facts about the runs of checked hand-ins by their names, and why some could not be looked at. */
export interface Looks {
  readonly facts: ReadonlyMap<string, RunFacts>;
  readonly unseen: ReadonlyMap<string, Reason>;
}

/** Looks at the runs of checked hand-ins: those that have not passed are run once more. */
export async function lookAtAll(
  task: ClassTask,
  results: readonly NamedResult[],
  { sources, firmware, jobs }: { readonly sources: readonly Source[]; readonly firmware: WebAssembly.Module; readonly jobs: number }, // prettier-ignore
): Promise<Looks> {
  const facts = new Map<string, RunFacts>();
  const unseen = new Map<string, Reason>();
  const start = threads<FactsRequest, RunFacts | null>('facts-worker', (): Omit<CheckerData, 'shared'> => {
    return { task: projectOfTask(task), firmware, starts: [] };
  });
  const failed = results.filter(({ result }) => !result.passed);
  const lanes = Array.from({ length: Math.min(jobs, failed.length) }, () => new Asker(start, every, longestMs(task)));
  const byName = new Map(sources.map((source) => [source.name, source]));
  await inLanes(failed, lanes, async ({ name, result }, _, lane) => {
    const source = byName.get(name);
    const content = source === undefined ? null : await contentOf(source);
    if (content === null || 'problem' in content) return;
    const ending = await lane.ask({ handIn: content.handIn, result });
    if ('reason' in ending) unseen.set(name, ending.reason);
    else if (ending.result !== null) facts.set(name, ending.result);
  });
  return { facts, unseen };
}

/** The groups of a class. */
export const groupsIn = (
  { handIns }: ClassResult,
  { project }: ClassTask,
  { facts, unseen }: Looks,
): readonly Group[] =>
  groupsOf(
    handIns.map(({ name, result }) => {
      const reason = unseen.get(name);
      return { name, result, facts: facts.get(name) ?? null, ...(reason && { unseen: reason }) };
    }),
    project.scene.size,
  );

/** A group in one line, as the teacher and other programs have it. */
export const groupSaid = (group: Group, { worlds: [first] }: ClassTask, language: Language) => ({
  title: groupTitle(group, language),
  fact: groupFact(group, first.id, language),
});

/** The groups as a report shows them, which the class may see. */
export const reportGroups = (
  groups: readonly Group[],
  { handIns }: ClassResult,
  task: ClassTask,
  language: Language,
): readonly ReportGroup[] =>
  groups.map((one) => {
    const { group, title, fact } = saidToClass(one, task, language);
    const world = group.world ?? task.worlds[0].id;
    const results = new Map(handIns.map(({ name, result }) => [name, result]));
    const trails = group.members.map((name) => results.get(name)?.worlds.find(({ id }) => id === world)?.trail ?? []);
    return {
      ...{ title, fact },
      ways: { world, trails, tone: groupSign(group), example: null, mark: null },
    };
  });
