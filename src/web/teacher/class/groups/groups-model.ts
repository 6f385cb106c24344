import type { HandIn } from '#check/hand-in/hand-in';
import { Asker, inLanes, type Every, type Start } from '#check/lane';
import type { CheckResult } from '#check/result';
import { secondsOf, type ClassTask } from '#check/task/task';
import type { GroupHint } from '#hint/groups/group-hint';
import { groupsOf, type Group } from '#hint/groups/groups';
import { needsRun, type RunFacts } from '#hint/groups/run-facts';
import { computed, shallowRef, type ShallowRef } from 'vue';

import type { Services } from '../../../session/run/worker/serve/protocol';
import type { ClassModel, Row } from '../model/class-model';

/** The means of groups: workers that look at runs, and that search hints. */
export interface GroupsPorts {
  /** Rejects without the VM. */
  looker(task: ClassTask): Promise<Start<Services['facts']['request'], RunFacts | null>>;
  hinter(task: ClassTask): Promise<Start<Services['group-hint']['request'], GroupHint | null>>;
  readonly every: Every;
  readonly lanes: number;
}

/** The search for the hint to a group. `nothing`: it could not be searched. */
export type Searched = 'searching' | 'nothing' | GroupHint;

/** The most programs that are tried for the hint to a group. Chosen: some ten seconds. */
const BUDGET = 250;
/** Longest time in one request, in ms of wall time. Chosen: a search on a slow computer. */
const LONG_MS = 600_000;

/** The groups of a class by what the runs did. */
export class GroupsModel {
  /** The hand-ins with a result whose runs were looked at, and those that need no look. */
  readonly groups = computed((): readonly Group[] => {
    const scene = this.model.task.value?.task.project.scene;
    return scene === undefined ? [] : groupsOf(this.known.value, scene.size);
  });
  /** Number of hand-ins whose runs are not looked at yet, or that are being checked. */
  readonly waiting = computed(() => this.model.rows.value.length - this.known.value.length);
  readonly hints: ShallowRef<ReadonlyMap<string, Searched>> = shallowRef(new Map());
  private readonly facts: ShallowRef<ReadonlyMap<CheckResult, RunFacts | null>> = shallowRef(new Map());
  private readonly known = computed(() =>
    this.model.rows.value.flatMap(({ name, result }) => {
      if (result === null) return [];
      const facts = this.facts.value.get(result);
      return facts === undefined && needsRun(result) ? [] : [{ name, result, facts: facts ?? null }];
    }),
  );
  private isLooking = false;
  private searching: Asker<Services['group-hint']['request'], GroupHint | null> | null = null;

  constructor(
    private readonly model: Pick<ClassModel, 'task' | 'rows'>,
    private readonly ports: GroupsPorts,
  ) {}

  /** Looks at the runs of all hand-ins that are checked and were not looked at. */
  async look(): Promise<void> {
    if (this.isLooking) return;
    this.isLooking = true;
    try {
      for (let rows = this.unseen(); rows.length > 0; rows = this.unseen()) await this.lookAt(rows);
    } catch {
      // Without the VM the page has said so: nothing is checked either.
    }
    this.isLooking = false;
  }

  /** The name under which the hint to a group is found. */
  readonly hintKey = ({ key, members }: Group): string => [key, ...members].join('\n');

  /** Searches the hint to a group, and ends another search. */
  async search(group: Group): Promise<void> {
    const key = this.hintKey(group);
    const before = this.hints.value.get(key);
    const task = this.model.task.value?.task;
    if (before !== undefined || task === undefined) return;
    this.stopSearch();
    this.say(key, 'searching');
    try {
      const asker = new Asker(await this.ports.hinter(task), this.ports.every, LONG_MS);
      if (this.hints.value.get(key) !== 'searching') return;
      this.searching = asker;
      const handIns = this.handInsOf(group);
      const ending = await asker.ask({ handIns, budget: BUDGET });
      asker.stop();
      this.say(key, ('result' in ending ? ending.result : null) ?? 'nothing');
    } catch {
      this.say(key, 'nothing');
    }
  }

  /** Ends a search; it begins anew when its group is opened again. */
  stopSearch(): void {
    this.searching?.stop();
    this.searching = null;
    this.hints.value = new Map([...this.hints.value].filter(([, found]) => found !== 'searching'));
  }

  /** The hand-ins of a group, its example first. */
  handInsOf({ members, example }: Group): readonly HandIn[] {
    const rows = new Map(this.model.rows.value.map((row) => [row.name, row]));
    return [example, ...members.filter((name) => name !== example)].flatMap((name) => rows.get(name)?.handIn ?? []);
  }

  private unseen(): readonly Row[] {
    return this.model.rows.value.filter(
      ({ result, handIn }) => result !== null && handIn !== null && needsRun(result) && !this.facts.value.has(result),
    );
  }

  private async lookAt(rows: readonly Row[]): Promise<void> {
    const task = this.model.task.value?.task;
    if (task === undefined) return;
    const start = await this.ports.looker(task);
    const mostMs = Math.max(LONG_MS, 1000 * secondsOf(task));
    const lanes = Array.from({ length: Math.min(this.ports.lanes, rows.length) }, () => new Asker(start, this.ports.every, mostMs)); // prettier-ignore
    await inLanes(rows, lanes, async ({ handIn, result }, _, lane) => {
      if (handIn === null || result === null) return;
      const ending = await lane.ask({ handIn, result });
      this.facts.value = new Map([...this.facts.value, [result, 'result' in ending ? ending.result : null]]);
    });
  }

  private say(key: string, found: Searched): void {
    this.hints.value = new Map([...this.hints.value, [key, found]]);
  }
}
