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
import { extraChanges, indentChanges, isWellFormed, orderChanges } from './changes/lines';
import { elseChanges, missingChanges } from './changes/missing';
import { nameChanges, relatedNameChanges } from './changes/names';
import { between, coarseValues, FIRST_STEPS, numbersOf, type NumberPlace, type Tried } from './changes/numbers';
import { readProgram, type Program } from './changes/program';
import { branchChanges, comparisonChanges, logicChanges, polarityChanges } from './changes/signs';
import { Stall } from './watch/stall';

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
  /** How likely it is that the fault is in a line: the lines from the most likely on. */
  readonly suspects: readonly number[];
  /** True if the program does not even begin: then only changes count that make it one. */
  readonly isBroken: boolean;
  /** Called often. */
  readonly beat: () => void;
}

/** The end of a search. */
export interface Found {
  /** A change that was proved; `null`: none was found. */
  readonly change: Change | null;
  /** Number of programs that were tried. */
  readonly tried: number;
}

/** Chosen: most runs of a try are over sooner, and a school's computer does a thousand simulated seconds in two or three. */
const SECONDS_PER_TRY = 12;

/** Tries one program after the other. */
class Trials {
  tried = 0;
  private seconds = 0;
  private readonly known = new Map<string, number>();

  constructor(private readonly search: Search) {}

  /** True once no more may be tried. */
  get isOver(): boolean {
    const { budget } = this.search;
    return this.tried >= budget || this.seconds >= budget * SECONDS_PER_TRY;
  }

  /** How far the program gets as it is. */
  async scoreBefore(): Promise<number> {
    return (await this.run(this.search.handIn)) ?? -Infinity;
  }

  /** True if the program passes with a change. */
  async passes(change: Change): Promise<boolean> {
    return (await this.score(change)) === Infinity;
  }

  /** How far a changed program gets; infinite: it passes. */
  async score(change: Change): Promise<number> {
    const { handIn, task, firmware, beat } = this.search;
    const text = withChange(mainOf(handIn), change);
    const known = this.known.get(text);
    if (known !== undefined) return known;
    if (this.isOver || !this.isAllowed(text)) return -Infinity;
    const changed = withMain(handIn, text);
    this.tried += 1;
    let score = (await this.run(changed)) ?? Infinity;
    // What was seen by an onlooker is proved as hand-ins are checked.
    if (score === Infinity && !(await check(task, changed, { firmware, beat })).passed) score = -Infinity;
    this.known.set(text, score);
    return score;
  }

  /** How far a program gets in the first world in which it does not pass; `null`: it passes in all. */
  private async run({ project }: HandIn): Promise<number | null> {
    const { task, failedIn, firmware, beat } = this.search;
    const comesAgain = task.checks.some(({ type }) => type === 'laps');
    for (const world of [failedIn, ...task.worlds.filter((one) => one !== failedIn)]) {
      const stall = new Stall(task.project.scene, comesAgain);
      const result = await runWorld(task, project, world, { firmware, beat, onlooker: stall });
      this.seconds += stall.seconds;
      if (!result.passed || stall.hasEnough) return stall.score + result.held.length * HELD_MM;
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

/** A check that holds is worth more than any place. */
const HELD_MM = 10_000_000;

/** The program of the first device. */
export const mainOf = ({ project }: HandIn): string => runFilesOf(project, 0)[MAIN] ?? '';

/** A hand-in with another program of its first device. */
export const withMain = (handIn: HandIn, text: string): HandIn => {
  const files = { ...runFilesOf(handIn.project, 0), [MAIN]: text };
  const named = Object.entries(files).map(([name, content]) => ({ name, text: content }));
  return { ...handIn, project: withFiles(handIn.project, 0, named) };
};

/** Searches for a small change with which the program passes: likely kinds first, and of each the likely lines first. */
export async function findChange(search: Search): Promise<Found> {
  const program = readProgram(mainOf(search.handIn));
  const trials = new Trials(search);
  const change = await searchIn(program, trials, search);
  return { change, tried: trials.tried };
}

async function searchIn(program: Program, trials: Trials, { suspects }: Search): Promise<Change | null> {
  const inOrder = (...makers: readonly ((of: Program) => readonly Change[])[]): readonly Change[] =>
    makers.flatMap((make) => bySuspicion(make(program), program, suspects));
  const numbers = new NumberSearch(numbersInOrder(program, suspects), trials);
  const missing = missingChanges(program);
  const steps: readonly (() => Promise<Change | null>)[] = [
    () => firstOf(inOrder(polarityChanges, nameChanges, comparisonChanges, logicChanges), trials),
    () => numbers.coarse(0, FIRST_STEPS),
    () => numbers.finer(FIRST_FINER),
    () => firstOf(inOrder(branchChanges, extraChanges, orderChanges, indentChanges), trials),
    () => firstOf(missing.slice(0, LIKELY), trials),
    () => numbers.coarse(FIRST_STEPS, Infinity),
    () => numbers.finer(FINER),
    () => firstOf(inOrder(relatedNameChanges), trials),
    () =>
      firstOf([...missing.slice(LIKELY, 3 * LIKELY), ...elseChanges(program), ...missing.slice(3 * LIKELY)], trials),
    () => numbers.finer(Infinity),
  ];
  for (const step of steps) {
    const found = await step();
    if (found !== null || trials.isOver) return found;
  }
  return null;
}

/** Numbers of tries after which another kind of change is looked at. Chosen: of each kind the likely ones come first. */
const [LIKELY, FIRST_FINER, FINER] = [50, 24, 80];

async function firstOf(changes: readonly Change[], trials: Trials): Promise<Change | null> {
  for (const change of changes) {
    if (trials.isOver) return null;
    if (await trials.passes(change)) return change;
  }
  return null;
}

/** The changes of likely lines first; of a line in their order. */
const bySuspicion = <T extends { readonly line: number }>(
  changes: readonly T[],
  { lines }: Program,
  suspects: readonly number[],
): readonly T[] => {
  const ranks = new Map(suspects.map((line, rank) => [line, rank]));
  const rank = ({ line }: T): number =>
    (ranks.get(line) ?? suspects.length) + (SHOWS.test(lines[line - 1]?.code ?? '') ? suspects.length : 0);
  return [...changes].sort((one, other) => rank(one) - rank(other));
};

/** Statements that only show something: the robot drives the same with and without them. */
const SHOWS = /^(setLED|fillRGB|posRGB|setRGB|clearRGB|display|print|music|setAlarm|beep|speech)/;

const numbersInOrder = (program: Program, suspects: readonly number[]): readonly NumberPlace[] =>
  bySuspicion(numbersOf(program), program, suspects);

/** Tries other values of the numbers of a program: coarse steps first, then halving between them. */
class NumberSearch {
  private readonly values: readonly (readonly [NumberPlace, Tried[]])[];

  constructor(
    places: readonly NumberPlace[],
    private readonly trials: Trials,
  ) {
    this.values = places.map((place) => [place, []]);
  }

  /** Coarse steps, those at these places in their order: of each number in turn. */
  async coarse(from: number, to: number): Promise<Change | null> {
    if (from === 0) {
      const score = await this.trials.scoreBefore();
      for (const [place, tried] of this.values) tried.push({ value: place.value, score });
    }
    const steps = this.values.map(([place]) => coarseValues(place));
    const last = Math.min(to, Math.max(0, ...steps.map(({ length }) => length)));
    for (let step = from; step < last; step += 1)
      for (const [at, [place, tried]] of this.values.entries()) {
        const value = steps[at]?.[step];
        if (value === undefined) continue;
        if (this.trials.isOver) return null;
        const found = await this.look(place, tried, value);
        if (found !== null) return found;
      }
    return null;
  }

  /** Halves: in turn where a run got farthest, and where the gap is widest. @param most tries */
  async finer(most: number): Promise<Change | null> {
    for (let count = 0; count < most && !this.trials.isOver; count += 1) {
      const gaps = this.values.flatMap(([place, tried]) =>
        between(place, tried).map((gap) => ({ ...gap, place, tried })),
      );
      const best = gaps.reduce<(typeof gaps)[number] | null>((least, gap) => {
        if (least === null) return gap;
        const isBetter = count % 2 === 0 ? gap.score > least.score : gap.ratio > least.ratio;
        return isBetter ? gap : least;
      }, null);
      if (best === null) return null;
      const found = await this.look(best.place, best.tried, best.value);
      if (found !== null) return found;
    }
    return null;
  }

  private async look(place: NumberPlace, tried: Tried[], value: number): Promise<Change | null> {
    const change = place.to(value);
    if (change === null) return null;
    const score = await this.trials.score(change);
    tried.push({ value, score });
    return score === Infinity ? change : null;
  }
}
