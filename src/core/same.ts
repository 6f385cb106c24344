/** True if two pieces of plain data are equal, in any order of their properties. `NaN` equals `NaN`. */
export function isSame(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null)
    return Number.isNaN(a) && Number.isNaN(b);
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((value, index) => isSame(value, b[index]));
  const values = new Map(Object.entries(a));
  const others = Object.entries(b);
  return (
    values.size === others.length && others.every(([key, value]) => values.has(key) && isSame(values.get(key), value))
  );
}
