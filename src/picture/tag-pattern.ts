/**
 * The patterns of the tags 36h11 (AprilTag, University of Michigan; its authors let anybody use and embed them): a black
 * square of 8 × 8 cells around 6 × 6 that are black or white. A pattern is a number of 36 bits, row by row from the upper left,
 * 1 is white. Each is a multiple of a prime behind the first; which multiples differ enough from all before is the family.
 */
const FIRST = 0xd5d628584;
const PRIME = 982_451_653;
const ALL = 0x1000000000; // 2³⁶
/** How many primes the tags 1, 2, 3, … lie behind the one before each. */
// prettier-ignore
const STEPS = [
  1, 1, 2, 2, 2, 5, 3, 5, 1, 4, 3, 1, 1, 2, 1, 2, 4, 1, 5, 1, 1, 2, 5, 1, 3, 1, 2, 7, 1, 4, 20, 6, 5, 4, 1, 1, 1, 8, 5, 4,
  4, 6, 2, 3, 6, 8, 4, 2, 5, 15, 4, 2, 5, 10, 3, 19, 8, 16, 2, 6, 1, 1, 6, 2, 3, 70, 8, 17, 15, 1, 6, 18, 19, 13, 7, 8, 3,
  7, 31, 31, 7, 33, 31, 8, 19, 11, 22, 30, 45, 1, 15, 9, 18, 13, 3, 20, 12, 42, 6,
];

/** Cells along the inside of a tag. */
export const TAG_INSIDE = 6;

/** The inside of a tag, row by row from the upper left: true is white. */
export function tagPattern(number: number): readonly (readonly boolean[])[] {
  const steps = STEPS.slice(0, number).reduce((sum, step) => sum + step, 0);
  const code = (FIRST + steps * PRIME) % ALL;
  return Array.from({ length: TAG_INSIDE }, (_, row) =>
    Array.from({ length: TAG_INSIDE }, (_, column) => {
      const bit = TAG_INSIDE * TAG_INSIDE - 1 - (row * TAG_INSIDE + column);
      return Math.floor(code / powerOfTwo(bit)) % 2 === 1;
    }),
  );
}

const powerOfTwo = (bit: number): number => (bit < 30 ? 1 << bit : (1 << 30) * (1 << (bit - 30)));
