/** The display as text for screen readers: five rows of five digits 0 … 9, the digits apart so that each is read. */
export function displayText(levels: readonly number[]): string {
  return [0, 1, 2, 3, 4]
    .map((row) => [0, 1, 2, 3, 4].map((column) => String(levels[row * 5 + column] ?? 0)).join(' '))
    .join(', ');
}
