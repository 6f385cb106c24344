const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i;
const WITH_COMMA = /^[+-]?\d*,\d+(?:e[+-]?\d+)?$/i;

/** A cell with a point instead of a decimal comma and a plain minus sign, if it is a number then; else as it is. */
export function plainNumber(cell: string, hasDecimalComma: boolean): string {
  const text = cell.replace('\u2212', '-');
  if (hasDecimalComma && WITH_COMMA.test(text)) return text.replace(',', '.');
  return NUMBER.test(text) ? text : cell;
}

/** True if a cell is a number that can be drawn, which `nan`, `inf`, words and out-of-range numbers are not. */
export const isNumber = (cell: string): boolean => NUMBER.test(cell) && Number.isFinite(Number(cell));
