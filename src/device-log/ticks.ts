/** Steps that are easy to read, in each power of ten. */
const STEPS = [1, 2, 5, 10];

/** Round values from below the least to above the largest, about that many. A single value gets room on both sides. */
export function ticksFor(min: number, max: number, about: number): readonly number[] {
  const [low, high] = min === max ? [min - (Math.abs(min) || 1) / 2, max + (Math.abs(max) || 1) / 2] : [min, max];
  const rough = (high - low) / about;
  const power = Number(`1e${String(exponentOf(rough))}`);
  const step = (STEPS.find((it) => it * power >= rough) ?? 10) * power;
  const first = Math.floor(low / step);
  const count = Math.ceil(high / step) - first;
  return Array.from({ length: count + 1 }, (_, place) => Number(((first + place) * step).toPrecision(12)));
}

/** The power of ten of a number above 0. */
const exponentOf = (value: number): number => Number(/e([+-]\d+)$/.exec(value.toExponential())?.[1] ?? 0);
