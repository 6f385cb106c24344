import type { Language } from '#core/languages';
import type { Choice, Content } from '#intake/contents';
import type { HandIn } from '#check/hand-in/hand-in';
import { brokenSource, contentOf, withOwnNames, type Source } from '#intake/sources';
import { unread } from '#check/hand-in/unread';
import { inLanes, Lane, type Every, type StartThread } from '#check/lane';
import { classResult, type ClassResult } from '#check/report/class-result';
import { shownNames } from '#check/report/names';
import { unreadable, type CheckResult } from '#check/result';
import type { Series } from '#check/series/series';
import type { ClassTask } from '#check/task/task';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { troubleKey, type TroubleKey } from '../../../session/run/worker/firmware-trouble';

/** The task that hand-ins are checked for. */
export interface OpenTask {
  readonly name: string;
  /** Its source: `open`, `file`, `series` or `kept` (`use-class.ts`), or the id of a ready course. */
  readonly from: string;
  readonly task: ClassTask;
}

/** The series that was brought last, with the id of the task that is checked. */
export interface Brought {
  /** `null`: there is none. */
  readonly chosen: { readonly series: Series; readonly task: string } | null;
  /** The reason why a series that was brought later cannot be had, in words; `null`: none. */
  readonly problem: string | null;
}

/** A hand-in on the page. */
export interface Row {
  /** Unlike the others. */
  readonly name: string;
  /** The name as people read it, without what a platform adds; unlike the others, too. */
  readonly shown: string;
  /** `null`: not read yet, or nothing that could be. */
  readonly handIn: HandIn | null;
  /** `null`: it waits, or is being checked. */
  readonly result: CheckResult | null;
  /** The teacher's note; empty: none. */
  readonly note: string;
  /** Points that the teacher has set by hand; left out: those of the checks count. */
  readonly marked?: number;
  /** The files of which one is the program; left out: it is known which. */
  readonly choices?: readonly Choice[];
}

/** A hand-in as it can be stored: plain data. */
export interface KeptRow extends Omit<Row, 'handIn' | 'shown' | 'choices'> {
  readonly content: Content;
}

/** The services that a class needs. */
export interface ClassPorts {
  /** Gives a function that starts threads for a task. Rejects without the VM. */
  starter(task: ClassTask): Promise<StartThread>;
  readonly every: Every;
  readonly lanes: number;
  /** The language of the page, in whose order names stand. */
  language(): Language;
}

/** A class: the task, the hand-ins, and their results. It stays while the page is open. */
export class ClassModel {
  readonly task = shallowRef<OpenTask | null>(null);
  readonly brought: ShallowRef<Brought> = shallowRef({ chosen: null, problem: null });
  readonly rows: ShallowRef<readonly Row[]> = shallowRef([]);
  readonly isChecking = shallowRef(false);
  /** The reason why nothing can be checked: there is no VM, or no worker; `null`: it can. */
  readonly failure: ShallowRef<TroubleKey | null> = shallowRef(null);
  /** The checked hand-ins as reports have them, with the remarks on twins. */
  readonly found: ComputedRef<ClassResult>;
  /** True if there are results or notes that were neither saved to a file nor printed. */
  readonly isUnsaved = computed(
    () =>
      this.rows.value !== this.saved.value &&
      this.rows.value.some(({ result, note }) => result !== null || note !== ''),
  );
  private readonly saved: ShallowRef<readonly Row[]> = shallowRef([]);
  private sources: readonly Source[] = [];
  private turn = 0;
  private lanes: readonly Lane[] = [];

  constructor(private readonly ports: ClassPorts) {
    this.found = computed(() =>
      classResult(
        this.task.value?.name ?? '',
        this.rows.value.flatMap(({ name, shown, result, note, marked }) =>
          result === null ? [] : [{ ...{ name, result, note, ...markedIn(marked) }, ...(shown !== name && { shown }) }],
        ),
        ports.language(),
      ),
    );
  }

  /** Sets another task: everything is checked again. */
  async choose(task: OpenTask): Promise<void> {
    this.task.value = task;
    // Points set by hand were for the task before.
    this.rows.value = this.rows.value.map(({ marked: _, ...row }) => ({ ...row, result: null }));
    await this.check();
  }

  /** Leaves the task: the results for it are dropped. */
  leaveTask(): void {
    this.stop();
    this.task.value = null;
    this.rows.value = this.rows.value.map((row) => ({ ...row, result: null }));
  }

  /** Adds hand-ins, and checks them. Of several with one name each gets its own. */
  async add(sources: readonly Source[]): Promise<void> {
    const named = withOwnNames(
      sources,
      this.rows.value.map(({ name }) => name),
    );
    this.sources = [...this.sources, ...named];
    this.rows.value = withShown([
      ...this.rows.value,
      ...named.map(({ name }) => ({ name, handIn: null, result: null, note: '' })),
    ]);
    await this.check();
  }

  /** Takes one of several files as the program of a hand-in. */
  async take(name: string, { handIn }: Choice): Promise<void> {
    this.sources = this.sources.map((source) => (source.name === name ? { name, read: () => ({ handIn }) } : source));
    this.rows.value = this.rows.value.map((row) => (row.name === name ? { ...row, handIn, result: null } : row));
    await this.check();
  }

  /** Sets the teacher's note on a hand-in. */
  write(name: string, note: string): void {
    this.rows.value = this.rows.value.map((row) => (row.name === name ? { ...row, note } : row));
  }

  /** Sets the points of a hand-in by hand. @param marked `null`: those of the checks count again */
  mark(name: string, marked: number | null): void {
    this.rows.value = this.rows.value.map(({ marked: before, ...row }) =>
      row.name === name ? { ...row, ...markedIn(marked ?? undefined) } : { ...row, ...markedIn(before) },
    );
  }

  /** A hand-in with its content, which may have to be read first. */
  async keptRow({ name, result, note, marked }: Row): Promise<KeptRow> {
    const source = this.sources.find((one) => one.name === name) ?? brokenSource(name, unread('gone').problem);
    return { name, result, note, ...markedIn(marked), content: await contentOf(source) };
  }

  /** Puts a stored class in the place of this one. Nothing is checked. */
  restore(task: OpenTask | null, rows: readonly KeptRow[]): void {
    this.stop();
    this.task.value = task;
    this.sources = rows.map(({ name, content }) => ({ name, read: () => content }));
    this.rows.value = withShown(rows.map(({ content, ...row }) => ({ ...row, ...readOf(content) })));
  }

  /**
   * Removes all hand-ins.
   *
   * @returns a function that brings them back, with results and notes, as long as nothing else was handed in
   */
  clear(): () => void {
    const [sources, rows] = [this.sources, this.rows.value];
    this.stop();
    this.sources = [];
    this.rows.value = [];
    return () => {
      if (this.rows.value.length > 0) return;
      this.sources = sources;
      this.rows.value = rows;
      void this.check();
    };
  }

  /** Marks the present state as saved to a file or printed. */
  noteSaved(): void {
    this.saved.value = this.rows.value;
  }

  /** Ends the checks in progress. */
  stop(): void {
    this.turn += 1;
    for (const lane of this.lanes) lane.stop();
    this.lanes = [];
    this.isChecking.value = false;
  }

  /** Checks the hand-ins that have no result yet. */
  async check(): Promise<void> {
    this.stop();
    const { turn } = this;
    const open = this.task.value;
    const waiting = this.rows.value.flatMap(({ result }, place) => (result === null ? [place] : []));
    if (waiting.length === 0) return;
    if (open === null) {
      for (const place of waiting) await this.readOne(place, turn);
      return;
    }
    this.isChecking.value = true;
    this.failure.value = null;
    try {
      const start = await this.ports.starter(open.task);
      if (turn !== this.turn) return;
      const count = Math.min(this.ports.lanes, waiting.length);
      this.lanes = Array.from({ length: count }, () => new Lane(open.task, start, this.ports.every));
      await inLanes(waiting, this.lanes, (place, _, lane) => this.checkOne(place, open.task, lane, turn));
    } catch (error) {
      if (turn === this.turn) this.failure.value = troubleKey(error);
    }
    if (turn === this.turn) this.stop();
  }

  /** Reads a hand-in before there is a task: perhaps it knows its own. */
  private async readOne(place: number, turn: number): Promise<void> {
    const [source, row] = [this.sources[place], this.rows.value[place]];
    if (source === undefined || row === undefined || row.handIn !== null || turn !== this.turn) return;
    const content = await contentOf(source);
    if (turn !== this.turn) return;
    const now = this.rows.value[place] ?? row;
    this.rows.value = this.rows.value.with(place, { ...now, ...readOf(content) });
  }

  private async checkOne(place: number, task: ClassTask, lane: Lane, turn: number): Promise<void> {
    const [source, row] = [this.sources[place], this.rows.value[place]];
    if (source === undefined || row === undefined || turn !== this.turn) return;
    const content = await contentOf(source);
    const result = 'problem' in content ? unreadable(task.checks, content.problem) : await lane.check(content.handIn);
    if (turn !== this.turn) return;
    // What is written meanwhile stays.
    const now = this.rows.value[place] ?? row;
    this.rows.value = this.rows.value.with(place, { ...now, ...readOf(content), result });
  }
}

/** The hand-in that was read, or the files of which one may be it. */
const readOf = (content: Content): Pick<Row, 'handIn' | 'choices'> =>
  'handIn' in content
    ? { handIn: content.handIn }
    : { handIn: null, ...(content.choices !== undefined && { choices: content.choices }) };

const markedIn = (marked: number | undefined): Pick<Row, 'marked'> => (marked === undefined ? {} : { marked });

function withShown(rows: readonly Omit<Row, 'shown'>[]): readonly Row[] {
  const shown = shownNames(rows.map(({ name }) => name));
  return rows.map((row, place) => ({ ...row, shown: shown[place] ?? row.name }));
}
