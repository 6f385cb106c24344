import type { Language } from '#core/languages';
import type { HandIn } from '#check/hand-in/hand-in';
import { Asker, inLanes, type Every, type Start } from '#check/lane';
import type { CheckResult } from '#check/result';
import { secondsOf, type ClassTask } from '#check/task/task';
import type { GroupHint } from '#hint/groups/group-hint';
import { groupsOf, type Group, type ToGroup } from '#hint/groups/groups';
import { needsRun } from '#hint/groups/needs-run';
import type { RunFacts } from '#hint/groups/run-facts';
import { isHidden } from '#hint/groups/say';
import { changeText, hintText } from '#hint/say';
import { mainOf } from '#hint/main-of';
import { computed, shallowRef, watch, type ShallowRef } from 'vue';

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

/** The search for the hint to a group. `nothing`: it could not be searched; `unloaded`: as a part of the code did not come. */
export type Searched = 'searching' | 'nothing' | 'unloaded' | GroupHint;

/** The facts of a run that was looked at, or why it could not be. */
type Look = Pick<ToGroup, 'facts' | 'unseen'>;

/** A search with the results of the hand-ins that it was about: with other ones it is about other programs. */
interface Kept {
  readonly results: readonly (CheckResult | null)[];
  readonly searched: Searched;
}

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
  private readonly hints: ShallowRef<ReadonlyMap<string, Kept>> = shallowRef(new Map());
  private readonly looks: ShallowRef<ReadonlyMap<CheckResult, Look>> = shallowRef(new Map());
  private readonly known = computed(() =>
    this.model.rows.value.flatMap(({ name, result, handIn }) => {
      if (result === null) return [];
      const look = this.looks.value.get(result);
      return look === undefined && needsRun(result) && handIn !== null ? [] : [{ name, result, facts: null, ...look }];
    }),
  );
  private isLooking = false;
  /** Counts the searches: what an earlier one finds is too late. */
  private turn = 0;
  private searching: Asker<Services['group-hint']['request'], GroupHint | null> | null = null;

  constructor(
    private readonly model: Pick<ClassModel, 'task' | 'rows'>,
    private readonly ports: GroupsPorts,
  ) {
    // The hints are to the task before.
    watch(
      model.task,
      () => {
        this.stopSearch();
        this.hints.value = new Map();
      },
      { flush: 'sync' },
    );
  }

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

  /** The hint to the hand-ins of a group as they are; `undefined`: it was not searched. */
  hintOf(group: Group): Searched | undefined {
    const kept = this.hints.value.get(keyOf(group));
    const results = this.resultsOf(group);
    return kept?.results.every((result, place) => result === results[place]) ? kept.searched : undefined;
  }

  /** Searches the hint to a group, and ends another search. A group that fails in a hidden world alone has none. */
  async search(group: Group): Promise<void> {
    const task = this.model.task.value?.task;
    const before = this.hintOf(group);
    if (task === undefined || isHidden(group, task) || (before !== undefined && before !== 'unloaded')) return;
    this.stopSearch();
    const { turn } = this;
    const [results, handIns] = [this.resultsOf(group), this.handInsOf(group)];
    const say = (searched: Searched): void => {
      if (turn === this.turn) this.hints.value = new Map([...this.hints.value, [keyOf(group), { results, searched }]]);
    };
    say('searching');
    try {
      const start = await this.ports.hinter(task);
      if (turn !== this.turn) return;
      const asker = (this.searching = new Asker(start, this.ports.every, LONG_MS));
      const ending = await asker.ask({ handIns, budget: BUDGET });
      asker.stop();
      const isUnloaded = 'reason' in ending && ending.reason.code === 'unloaded';
      say(isUnloaded ? 'unloaded' : (('result' in ending ? ending.result : null) ?? 'nothing'));
    } catch {
      say('nothing');
    }
  }

  /** Ends a search; it begins anew when its group is opened again. */
  stopSearch(): void {
    this.turn += 1;
    this.searching?.stop();
    this.searching = null;
    const found = [...this.hints.value].filter(([, { searched }]) => searched !== 'searching');
    if (found.length < this.hints.value.size) this.hints.value = new Map(found);
  }

  /** The hand-ins of a group, its example first. */
  handInsOf(group: Group): readonly HandIn[] {
    return this.rowsOf(group).flatMap(({ handIn }) => handIn ?? []);
  }

  /** The rows of a group with a program, its example first. */
  private rowsOf({ members, example }: Group): readonly Row[] {
    const rows = new Map(this.model.rows.value.map((row) => [row.name, row]));
    return [example, ...members.filter((name) => name !== example)].flatMap((name) => {
      const row = rows.get(name);
      return row === undefined || row.handIn === null ? [] : [row];
    });
  }

  /**
   * The hint in words to each hand-in of a group whose program passes with it, with its own lines, by their names. It tells
   * no change itself; what happened it tells of the example alone, whose run was seen to its end.
   */
  hintsInWords(group: Group, language: Language): ReadonlyMap<string, string> {
    const found = this.hintOf(group);
    if (typeof found !== 'object') return new Map();
    const told = this.rowsOf(group).flatMap(({ name, handIn }, place): readonly [string, string][] => {
      const change = found.changes[place] ?? null;
      if (handIn === null || change === null) return [];
      const program = mainOf(handIn);
      const isExample = place === 0;
      return [[name, isExample ? hintText({ ...found.hint, change, program }, 3, language) : changeText(program, change, 3, language)]]; // prettier-ignore
    });
    return new Map(told);
  }

  private unseen(): readonly Row[] {
    return this.model.rows.value.filter(
      ({ result, handIn }) => result !== null && handIn !== null && needsRun(result) && !this.looks.value.has(result),
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
      const look = 'result' in ending ? { facts: ending.result } : { facts: null, unseen: ending.reason };
      this.looks.value = new Map([...this.looks.value, [result, look]]);
    });
  }

  private resultsOf({ members }: Group): readonly (CheckResult | null)[] {
    const results = new Map(this.model.rows.value.map(({ name, result }) => [name, result]));
    return members.map((name) => results.get(name) ?? null);
  }
}

/** The name under which the hint to a group is kept. */
const keyOf = ({ key, members }: Group): string => [key, ...members].join('\n');
