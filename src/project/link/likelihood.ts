/**
 * The probability that the next decision is a yes, learned from earlier decisions. Every decision has several contexts.
 * Each context remembers how such decisions came out, and their predictions are mixed by weights that follow which
 * contexts were right. The code uses only + − × ÷ and `#core/exact-exp`, so that every browser computes the same
 * numbers; otherwise no link would open on another device.
 *
 * All numbers here were chosen by measuring links of the drawings in `testing/drawings.ts`; half or twice of each
 * changed less than 3 %. They are part of version 2 of links: none may ever change.
 */
import { exactExp, exactLog } from '#core/exact-exp';

import { CERTAIN } from './range-coder';

/** Slots for the memory of contexts. A link needs some 50,000; two contexts in one slot only cost a little room. */
const SLOTS = 1 << 18;

/** A slot counts up to this many decisions: each changes it less than the previous one, the last by a hundredth. */
const COUNTED = 100;

/** How fast the weights follow, and their start values. */
const LEARNING = 0.025;
const START_WEIGHT = 0.35;

/** The logarithm of the odds for a probability, in steps of 1/4096. */
const STEPS = 4096;
const LOG_ODDS = Float64Array.from({ length: STEPS }, (_, step) => exactLog((step + 0.5) / (STEPS - 0.5 - step)));

/** Trust in a slot by the number of decisions that it has counted. */
const TRUST = Float64Array.from({ length: COUNTED + 1 }, (_, seen) => seen / (seen + 0.4));

/**
 * The probability for a logarithm of odds, in steps of 1/256, −11 to 11: beyond is finer than `CERTAIN` can express.
 */
const ODDS_STEPS = 256;
const MOST_STEPS = 11 * ODDS_STEPS;
const CHANCES = Float64Array.from(
  { length: 2 * MOST_STEPS + 1 },
  (_, step) => 1 / (1 + exactExp((MOST_STEPS - step) / ODDS_STEPS)),
);

/** The contexts' predictions for one decision after the other. */
export class Likelihood {
  private readonly chances: Float32Array;
  private readonly seen: Uint8Array;
  private readonly weights: Map<number, Float64Array>;
  private readonly slots: number[] = [];
  private readonly opinions: number[] = [];
  private mixed: Float64Array = new Float64Array();
  private chance = 0.5;

  /** @param taught initial knowledge, as a copy; left out: nothing */
  constructor(taught?: Likelihood) {
    this.chances = taught?.chances.slice() ?? new Float32Array(SLOTS).fill(0.5);
    this.seen = taught?.seen.slice() ?? new Uint8Array(SLOTS);
    this.weights = new Map([...(taught?.weights ?? [])].map(([mixer, weights]) => [mixer, weights.slice()]));
  }

  /**
   * The probability that a decision is a yes.
   *
   * @param contexts whole numbers for the circumstances of the decision
   * @param node the decision's number, in all these contexts
   * @param mixer the weights to use: shared by similar decisions
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

  /** Takes in the result of the decision for which `of` was last called. */
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

/** Combines two whole numbers to one of 32 bits that hardly any other two give. */
export function joined(one: number, other: number): number {
  let hash = Math.imul(one ^ (one >>> 15), 0x2545f491) + Math.imul(other + 0x3c6ef372, 0x9e3779b1);
  hash = Math.imul(hash ^ (hash >>> 16), 0x45d9f3b5);
  return hash ^ (hash >>> 13);
}
