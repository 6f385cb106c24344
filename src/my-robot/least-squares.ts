/**
 * Numbers that explain measurements best: the smallest sum of squares of `residuals` (each in units of its expected
 * error), found by Gauss–Newton steps with slopes taken from small changes. A step that makes it worse is halved.
 */
export interface Problem {
  readonly start: readonly number[];
  /** A change of each number that is small against what is looked for. */
  readonly small: readonly number[];
  readonly residuals: (numbers: readonly number[]) => Promise<readonly number[]>;
}

/** Most steps, and when one is too small to be worth another: chosen, three or four steps are usual. */
const STEPS = 8;
const ENOUGH = 1e-3;

/** Solves a problem with a few numbers and smooth residuals. */
export async function leastSquares({ start, small, residuals }: Problem): Promise<readonly number[]> {
  let best = start;
  let at = await residuals(best);
  for (let step = 0; step < STEPS; step += 1) {
    const slopes: number[][] = [];
    for (const [index, change] of small.entries()) {
      const moved = await residuals(best.map((value, other) => (other === index ? value + change : value)));
      slopes.push(moved.map((value, row) => (value - (at[row] ?? 0)) / change));
    }
    const way = downhill(slopes, at);
    const next = await stepAlong(best, way, at, residuals);
    if (next === null) break;
    const gain = squares(at) - squares(next.at);
    ({ numbers: best, at } = next);
    if (gain < ENOUGH) break;
  }
  return best;
}

const squares = (values: readonly number[]): number => values.reduce((sum, value) => sum + value * value, 0);

/** The farthest of a few halvings of a step that makes it better. */
async function stepAlong(
  from: readonly number[],
  way: readonly number[],
  at: readonly number[],
  residuals: Problem['residuals'],
): Promise<{ readonly numbers: readonly number[]; readonly at: readonly number[] } | null> {
  for (const share of [1, 0.5, 0.25, 0.1]) {
    const numbers = from.map((value, index) => value + share * (way[index] ?? 0));
    const there = await residuals(numbers);
    if (squares(there) < squares(at)) return { numbers, at: there };
  }
  return null;
}

/** The step of Gauss and Newton: the solution of the normal equations. */
function downhill(slopes: readonly (readonly number[])[], at: readonly number[]): readonly number[] {
  const dot = (one: readonly number[], other: readonly number[]): number =>
    one.reduce((sum, value, row) => sum + value * (other[row] ?? 0), 0);
  return solved(
    slopes.map((one) => slopes.map((other) => dot(one, other))),
    slopes.map((one) => -dot(one, at)),
  );
}

/** Solves linear equations by elimination; the matrix is symmetric and positive definite, so no rows are exchanged. */
function solved(matrix: readonly (readonly number[])[], right: readonly number[]): readonly number[] {
  const rows = matrix.map((row, index) => [...row, right[index] ?? 0]);
  for (const [index, pivot] of rows.entries())
    for (const [other, row] of rows.entries()) {
      if (other === index) continue;
      const factor = (row[index] ?? 0) / (pivot[index] ?? 1);
      for (let column = index; column < row.length; column += 1)
        row[column] = (row[column] ?? 0) - factor * (pivot[column] ?? 0);
    }
  return rows.map((row, index) => (row[rows.length] ?? 0) / (row[index] ?? 1));
}
