import { check } from '#check/check';
import type { HandIn } from '#check/hand-in/hand-in';
import { findFact } from '#check/program/facts';
import { runWorld } from '#check/run/run-world';
import { keptLines } from '#check/task/kept-lines';
import { isFact, type ClassTask, type WorldVariant } from '#check/task/task';
import { runFilesOf, withFiles } from '#project/devices';
import { MAIN } from '#project/project';
import type { Change } from './changes/change';
import { withChange } from './changes/change';
import { isRight, isWellFormed } from './changes/lines';
import type { Program } from './changes/program';
import { mattersTo } from './changes/reach';
import { mainOf } from './main-of';
import { scoreOf, Stall } from './watch/stall';

/** A search for a small change with which a program passes. */
export interface Search {
  /** The task as pupils see it. */
  readonly task: ClassTask;
  readonly handIn: HandIn;
  readonly firmware: WebAssembly.Module;
  /** The most programs that are tried. */
  readonly budget: number;
  /** The world in which the program failed: there it is tried first. */
  readonly failedIn: WorldVariant;
  /** How far it got there. */
  readonly score: number;
  /** The lines that ran there; `null`: it failed for another reason than its run. */
  readonly ran: ReadonlySet<number> | null;
  /** How likely it is that the fault is in a line: the lines from the most likely on. */
  readonly suspects: readonly number[];
  /** True if the program does not even begin: then only changes count that make it one. */
  readonly isBroken: boolean;
  /** Called often, with the number of programs tried, this one included. */
  readonly beat: (tried: number) => void;
}

/** Chosen: most runs of a try are over sooner, and a school's computer does a thousand simulated seconds in two or three. */
const SECONDS_PER_TRY = 12;

/** Tries one program after the other. */
export class Trials {
  tried = 0;
  private seconds = 0;
  private readonly known = new Map<string, number>();
  private readonly matters: (change: Change) => boolean;

  constructor(
    private readonly program: Program,
    private readonly search: Search,
  ) {
    this.matters = search.ran === null ? () => true : mattersTo(program, search.ran);
  }

  /** True once no more may be tried. */
  get isOver(): boolean {
    const { budget } = this.search;
    return this.tried >= budget || this.seconds >= budget * SECONDS_PER_TRY;
  }

  /** True if the program passes with a change. */
  async passes(change: Change): Promise<boolean> {
    return (await this.score(change)) === Infinity;
  }

  /** How far a changed program gets; infinite: it passes. */
  async score(change: Change): Promise<number> {
    const { handIn, task, firmware } = this.search;
    if (!this.matters(change)) return this.search.score;
    const text = withChange(mainOf(handIn), change);
    const known = this.known.get(text);
    if (known !== undefined) return known;
    if (this.isOver || !isRight(this.program, change) || !this.isAllowed(text)) return -Infinity;
    const changed = withMain(handIn, text);
    this.tried += 1;
    let score = (await this.run(changed)) ?? Infinity;
    // What was seen by an onlooker is proved as hand-ins are checked.
    if (score === Infinity && !(await check(task, changed, { firmware, beat: this.beat })).passed) score = -Infinity;
    this.known.set(text, score);
    return score;
  }

  private readonly beat = (): void => this.search.beat(this.tried);

  /** How far a program gets in the first world in which it does not pass; `null`: it passes in all. */
  private async run({ project }: HandIn): Promise<number | null> {
    const { task, failedIn, firmware } = this.search;
    for (const world of [failedIn, ...task.worlds.filter((one) => one !== failedIn)]) {
      const stall = new Stall(task);
      const result = await runWorld(task, project, world, { firmware, beat: this.beat, onlooker: stall });
      this.seconds += stall.seconds;
      if (!result.passed || stall.hasEnough) return scoreOf(stall, result);
    }
    return null;
  }

  /** True if the text is as the task wants it, and keeps the lines that are locked. */
  private isAllowed(text: string): boolean {
    const { task, handIn, isBroken } = this.search;
    if (isBroken && !isWellFormed(text)) return false;
    const { lines } = task.locks;
    const start = runFilesOf(task.project, 0)[MAIN] ?? '';
    const isKept = (program: string): boolean => lines.length === 0 || keptLines(start, program, lines) !== null;
    if (isKept(mainOf(handIn)) && !isKept(text)) return false;
    const files = { ...runFilesOf(handIn.project, 0), [MAIN]: text };
    return task.checks.every((one) => !one.needed || !isFact(one) || findFact(one, files).holds);
  }
}

/** A hand-in with another program of its first device. */
export const withMain = (handIn: HandIn, text: string): HandIn => {
  const files = { ...runFilesOf(handIn.project, 0), [MAIN]: text };
  const named = Object.entries(files).map(([name, content]) => ({ name, text: content }));
  return { ...handIn, project: withFiles(handIn.project, 0, named) };
};
