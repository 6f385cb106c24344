/**
 * Round numbers for an axis.
 *
 * @param most about so many
 * @param isInside true: none lies outside of the values
 */
export function ticksOf(values: readonly number[], most: number, isInside = false): readonly number[] {
  if (values.length === 0) return isInside ? [] : [0, 1];
  const low = values.reduce((one, other) => Math.min(one, other), Infinity);
  const high = values.reduce((one, other) => Math.max(one, other), -Infinity);
  const span = high - low || Math.abs(high) * 0.1 || 1;
  const power = 10 ** Math.floor(Math.log10(span / most));
  const step = power * ([1, 2, 5, 10].find((times) => times * power * most >= span) ?? 10);
  const [first, last] = isInside
    ? [Math.ceil(low / step - 1e-9), Math.floor(high / step + 1e-9)]
    : [Math.floor(low / step), Math.max(Math.ceil(high / step), Math.floor(low / step) + 1)];
  return Array.from({ length: last - first + 1 }, (_, place) => Number(((first + place) * step).toPrecision(12)));
}
