/**
 * How likely the next decision is a yes, learned from those before it: every decision is looked at in several contexts,
 * each of which remembers how such decisions came out, and their opinions are mixed by weights that follow who was right.
 * Only + − × ÷ and `#core/exact-math`: every browser comes to the same numbers, or no link would open on another device.
 *
 * All numbers here were chosen by measuring links of the drawings in `testing/drawings.ts`; half or twice of each changed
 * less than 3 %. They are part of version 2 of links: none may ever change.
 */
import { exactExp, exactLog } from '#core/exact-math';

import { CERTAIN } from './range-coder';

/** Slots for what contexts remember. A link needs some 50,000; two contexts in one slot only cost a little room. */
const SLOTS = 1 << 18;

/** So many decisions a slot counts: each changes it less than the one before, the last by a hundredth. */
const COUNTED = 100;

/** How fast the weights follow, and where they start. */
const LEARNING = 0.025;
const START_WEIGHT = 0.35;

/** The logarithm of the odds for a chance, in steps of 1/4096. */
const STEPS = 4096;
const LOG_ODDS = Float64Array.from({ length: STEPS }, (_, step) => exactLog((step + 0.5) / (STEPS - 0.5 - step)));

/** Trust in a slot by how many decisions it has counted. */
const TRUST = Float64Array.from({ length: COUNTED + 1 }, (_, seen) => seen / (seen + 0.4));

/** The chance for a logarithm of odds, in steps of 1/256 from −11 to 11: beyond it would be finer than `CERTAIN` can say. */
const ODDS_STEPS = 256;
const MOST_STEPS = 11 * ODDS_STEPS;
const CHANCES = Float64Array.from(
  { length: 2 * MOST_STEPS + 1 },
  (_, step) => 1 / (1 + exactExp((MOST_STEPS - step) / ODDS_STEPS)),
);

/** The contexts' opinions on one decision after the other. */
export class Likelihood {
  private readonly chances: Float32Array;
  private readonly seen: Uint8Array;
  private readonly weights: Map<number, Float64Array>;
  private readonly slots: number[] = [];
  private readonly opinions: number[] = [];
  private mixed: Float64Array = new Float64Array();
  private chance = 0.5;

  /** @param taught what it is to know already, as a copy; left out: nothing */
  constructor(taught?: Likelihood) {
    this.chances = taught?.chances.slice() ?? new Float32Array(SLOTS).fill(0.5);
    this.seen = taught?.seen.slice() ?? new Uint8Array(SLOTS);
    this.weights = new Map([...(taught?.weights ?? [])].map(([mixer, weights]) => [mixer, weights.slice()]));
  }

  /**
   * How likely a decision is a yes.
   *
   * @param contexts whole numbers for the circumstances under which the decision is made
   * @param node which decision it is, in all these contexts
   * @param mixer which weights are used: of decisions that are alike
   * @returns in parts of `CERTAIN`
   */
  of(contexts: readonly number[], node: number, mixer: number): number {
    this.mixed = this.weightsOf(mixer, contexts.length);
    this.slots.length = contexts.length;
    let sum = 0;
    for (let index = 0; index < contexts.length; index += 1) {
      const slot = joined(joined(contexts[index] ?? 0, index), node) & (SLOTS - 1);
      const step = Math.floor((this.chances[slot] ?? 0) * STEPS);
      const opinion = (LOG_ODDS[Math.min(step, STEPS - 1)] ?? 0) * (TRUST[this.seen[slot] ?? 0] ?? 0);
      this.slots[index] = slot;
      this.opinions[index] = opinion;
      sum += opinion * (this.mixed[index] ?? 0);
    }
    const odds = Math.max(-MOST_STEPS, Math.min(MOST_STEPS, Math.round(sum * ODDS_STEPS)));
    this.chance = CHANCES[odds + MOST_STEPS] ?? 0.5;
    return Math.max(1, Math.min(CERTAIN - 1, Math.round(this.chance * CERTAIN)));
  }

  /** Takes in how the decision came out that `of` was asked for last. */
  learn(bit: number): void {
    const error = bit - this.chance;
    for (let index = 0; index < this.slots.length; index += 1) {
      const slot = this.slots[index] ?? 0;
      this.mixed[index] = (this.mixed[index] ?? 0) + LEARNING * error * (this.opinions[index] ?? 0);
      const seen = this.seen[slot] ?? 0;
      const chance = this.chances[slot] ?? 0;
      this.chances[slot] = chance + (bit - chance) / (seen + 1.5);
      if (seen < COUNTED) this.seen[slot] = seen + 1;
    }
  }

  private weightsOf(mixer: number, count: number): Float64Array {
    let weights = this.weights.get(mixer);
    if (weights === undefined) {
      weights = new Float64Array(count).fill(START_WEIGHT);
      this.weights.set(mixer, weights);
    }
    return weights;
  }
}

/** Two whole numbers as one of 32 bits that hardly any other two give. */
export function joined(one: number, other: number): number {
  let hash = Math.imul(one ^ (one >>> 15), 0x2545f491) + Math.imul(other + 0x3c6ef372, 0x9e3779b1);
  hash = Math.imul(hash ^ (hash >>> 16), 0x45d9f3b5);
  return hash ^ (hash >>> 13);
}
