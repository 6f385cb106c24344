/** Lines as people write them: "1–4, 7". */
export function rangesText(lines: readonly number[]): string {
  const ranges: [number, number][] = [];
  for (const line of [...lines].sort((one, other) => one - other)) {
    const last = ranges.at(-1);
    if (last !== undefined && last[1] >= line - 1) last[1] = line;
    else ranges.push([line, line]);
  }
  return ranges.map(([from, to]) => (from === to ? String(from) : `${String(from)}–${String(to)}`)).join(', ');
}

/** The lines that were typed, with any dash and any separator; `null`: they are not lines of a text of this length. */
export function linesIn(typed: string, count: number): readonly number[] | null {
  const lines = new Set<number>();
  for (const part of typed.split(/[\s,;]+/u).filter((piece) => piece !== '')) {
    const [, first, last = first] = /^(\d{1,6})(?:[-–—](\d{1,6}))?$/u.exec(part) ?? [];
    const [from, to] = [Number(first), Number(last)];
    if (!(from >= 1 && from <= to && to <= count)) return null;
    for (let line = from; line <= to; line += 1) lines.add(line);
  }
  return [...lines].sort((one, other) => one - other);
}

/** The lines after a tap on one of them; with `from` all between the two become as that one is. */
export function toggled(lines: readonly number[], line: number, from: number | null): readonly number[] {
  if (from === null) return lines.includes(line) ? lines.filter((other) => other !== line) : inOrder([...lines, line]);
  const [first, last] = [Math.min(from, line), Math.max(from, line)];
  const others = lines.filter((other) => other < first || other > last);
  if (!lines.includes(from)) return others;
  return inOrder([...others, ...Array.from({ length: last - first + 1 }, (_, at) => first + at)]);
}

const inOrder = (lines: readonly number[]): readonly number[] => [...lines].sort((one, other) => one - other);
