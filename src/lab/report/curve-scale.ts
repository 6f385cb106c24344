/** Maps numbers evenly onto a stretch; all alike stand in its middle. */
export function curveScale(values: readonly number[], from: number, to: number): (value: number) => number {
  const low = values.reduce((one, other) => Math.min(one, other), Infinity);
  const high = values.reduce((one, other) => Math.max(one, other), -Infinity);
  const span = high - low;
  if (!(span > 0)) return () => Math.round((from + to) * 5) / 10;
  return (value) => Math.round((from + ((value - low) / span) * (to - from)) * 10) / 10;
}
