import { showsTypes, type Check, type ClassTask } from '#check/task/task';

import type { Change } from './changes/change';
import { extraChanges, indentChanges, orderChanges } from './changes/lines';
import { elseChanges, missingChanges, numbersInLine, unusedChanges, waitChanges } from './changes/missing';
import { nameChanges, relatedNameChanges } from './changes/names';
import { between, coarseValues, FIRST_STEPS, numbersOf, type NumberPlace, type Tried } from './changes/numbers';
import { readProgram, type Program } from './changes/program';
import { branchChanges, comparisonChanges, digitsIn, logicChanges, polarityChanges } from './changes/signs';
import { mainOf } from './main-of';
import { Trials, type Search } from './trials';

/** The end of a search. */
export interface Found {
  /** A change that was proved; `null`: none was found. */
  readonly change: Change | null;
  /** Number of programs that were tried. */
  readonly tried: number;
}

/** Searches for a small change with which the program passes: likely kinds first, and of each the likely lines first. */
export async function findChange(search: Search): Promise<Found> {
  const program = readProgram(mainOf(search.handIn));
  const trials = new Trials(program, search);
  const change = await searchIn(program, trials, search);
  return { change, tried: trials.tried };
}

async function searchIn(program: Program, trials: Trials, search: Search): Promise<Change | null> {
  const { suspects, score } = search;
  const inOrder = (...makers: readonly ((of: Program) => readonly Change[])[]): readonly Change[] =>
    makers.flatMap((make) => bySuspicion(make(program), program, search));
  const numbers = new NumberSearch(numbersInOrder(program, search), trials, score);
  const more = new LinesMore(trials, score);
  let found: readonly Change[] | null = null;
  const missing = (): readonly Change[] => (found ??= missingChanges(program, suspects));
  const steps: readonly (() => Promise<Change | null>)[] = [
    () => firstOf(inOrder(polarityChanges, nameChanges, comparisonChanges, logicChanges), trials),
    () => more.firstOf([...unusedChanges(program, suspects), ...inOrder(waitChanges)]),
    () => more.finer(),
    () => numbers.coarse(0, FIRST_STEPS),
    () => firstOf(inOrder(branchChanges), trials),
    () => numbers.finer(FIRST_FINER),
    () => firstOf(inOrder(extraChanges, orderChanges, indentChanges), trials),
    () => more.firstOf(missing().slice(0, LIKELY)),
    () => more.finer(),
    () => numbers.coarse(FIRST_STEPS, Infinity),
    () => numbers.finer(FINER),
    () => firstOf(inOrder(relatedNameChanges), trials),
    () =>
      more.firstOf([...missing().slice(LIKELY, 3 * LIKELY), ...elseChanges(program), ...missing().slice(3 * LIKELY)]),
    () => more.finer(),
    () => numbers.finer(Infinity),
  ];
  for (const step of steps) {
    const change = await step();
    if (change !== null || trials.isOver) return change;
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
  { suspects, task }: Search,
): readonly T[] => {
  const ranks = new Map(suspects.map((line, rank) => [line, rank]));
  const isLate = (line: number): boolean => !looksAtShown(task) && SHOWS.test(lines[line - 1]?.code ?? '');
  const rank = ({ line }: T): number => (ranks.get(line) ?? suspects.length) + (isLate(line) ? suspects.length : 0);
  return [...changes].sort((one, other) => rank(one) - rank(other));
};

/** Statements that only show something: the robot drives the same with and without them. */
const SHOWS = /^(setLED|fillRGB|posRGB|setRGB|clearRGB|display|print|music|setAlarm|beep|speech|log\.)/;

/** True if a check looks at what is shown, sent or written: then the fault may lie in a line that only does that. */
const looksAtShown = ({ checks }: ClassTask): boolean => checks.some(({ type }) => isShows(type));

const isShows = (type: Check['type']): boolean => showsTypes.some((one) => one === type);

/** The numbers that may matter: those that are only shown do where a check looks at that. */
function numbersInOrder(program: Program, search: Search): readonly NumberPlace[] {
  const digits = digitsIn(program);
  const matters = ({ from, line }: NumberPlace): boolean =>
    !digits.has(from) && (looksAtShown(search.task) || !SHOWS.test(program.lines[line - 1]?.code ?? ''));
  const numbers = numbersOf(program).filter(matters);
  return bySuspicion(numbers, program, search);
}

/** Tries other values of the numbers of a program: coarse steps first, then halving between them. */
class NumberSearch {
  private readonly values: readonly (readonly [NumberPlace, Tried[]])[];

  constructor(
    places: readonly NumberPlace[],
    private readonly trials: Trials,
    score: number,
  ) {
    this.values = places.map((place) => [place, [{ value: place.value, score }]]);
  }

  /** Coarse steps, those at these places in their order: of each number in turn. */
  async coarse(from: number, to: number): Promise<Change | null> {
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

/** Number of the lines more whose numbers are varied, and of coarse steps. Chosen: those that get farthest. */
const [FARTHEST_LINES, LINE_STEPS] = [4, 4];

/** Tries lines more. Where one gets the robot farther, but not far enough, its numbers may be other ones. */
class LinesMore {
  private farther: { readonly change: Change; readonly score: number }[] = [];

  constructor(
    private readonly trials: Trials,
    private readonly score: number,
  ) {}

  async firstOf(changes: readonly Change[]): Promise<Change | null> {
    for (const change of changes) {
      if (this.trials.isOver) return null;
      const score = await this.trials.score(change);
      if (score === Infinity) return change;
      if (score > this.score && change.after.length === 1) this.farther.push({ change, score });
    }
    return null;
  }

  /** Varies the numbers of those lines that got farthest since the last time. */
  async finer(): Promise<Change | null> {
    const farthest = this.farther.sort((one, other) => other.score - one.score).slice(0, FARTHEST_LINES);
    this.farther = [];
    for (const { change, score } of farthest) {
      const numbers = new NumberSearch(numbersInLine(change), this.trials, score);
      const found = (await numbers.coarse(0, LINE_STEPS)) ?? (await numbers.finer(2 * LINE_STEPS));
      if (found !== null) return found;
    }
    return null;
  }
}
