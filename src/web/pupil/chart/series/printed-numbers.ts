/** A number in a printed line. */
export interface Printed {
  /** As the line calls it; empty where it has no name. */
  readonly name: string;
  readonly value: number;
}

/** Longest line that is looked at. Chosen: nobody plots more numbers than fit into it. */
const MOST_CHARACTERS = 200;
/** More numbers than that are a table, no curves. */
const MOST_NUMBERS = 8;

const NUMBER = /[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/iy;
/** Words with `:` or `=` behind them, or a single word. */
const NAME = /(?:(\p{L}[\p{L}\p{N}_ .-]{0,29}?)\s*[:=]|(\p{L}[\p{L}\p{N}_]{0,29}))\s*/uy;
const BETWEEN = /[\s,;()[\]]*/y;
/** A unit behind a number; the name of the next number is none, nor is the `g` of `r 1 g 2 b 3`. */
const UNIT =
  /\s?(?:°C|°|%|cm\/s|mm\/s|m\/s|mm|cm|ms|us|µs|mV|Hz|mg|nT|uT|µT|grad|deg|[msVg](?!\s+[-+.\d]))(?![\p{L}\p{N}_])(?!\s*[:=])/uy;

/**
 * The numbers of a line that is meant to be plotted, or `null` for any other: as Mu takes them, `(1, 2)`, as MakeCode
 * does, `name:value`, and as pupils print them, `distance 23 cm` or `left 1 right 0`. In a line of prose a word is
 * followed by another one, not by a number.
 */
export function printedNumbers(line: string): readonly Printed[] | null {
  const text = line.trim();
  if (text === '' || text.length > MOST_CHARACTERS || text.startsWith('>>>') || text.startsWith('...')) return null;
  const found: Printed[] = [];
  let at = 0;
  const take = (pattern: RegExp): RegExpExecArray | null => {
    pattern.lastIndex = at;
    const match = pattern.exec(text);
    if (match !== null) at = pattern.lastIndex;
    return match;
  };
  take(BETWEEN);
  while (at < text.length) {
    const named = take(NAME);
    take(BETWEEN);
    const number = take(NUMBER);
    if (number === null || (/[\p{L}\p{N}_.:/-]/u.test(text.charAt(at)) && !startsUnit(text, at))) return null;
    found.push({ name: (named?.[1] ?? named?.[2] ?? '').trim(), value: Number(number[0]) });
    if (found.length > MOST_NUMBERS) return null;
    take(UNIT);
    take(BETWEEN);
  }
  return found.length > 0 && found.every(({ value }) => Number.isFinite(value)) ? found : null;
}

function startsUnit(text: string, at: number): boolean {
  UNIT.lastIndex = at;
  return UNIT.test(text);
}
