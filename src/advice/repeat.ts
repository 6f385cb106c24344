/** Names for counting, in the order in which loops within loops get them. */
const COUNTERS = ['i', 'j', 'k', 'm', 'n', 'p', 'q', 'r'];

const REPEAT = /^(\s*)repeat\b\s*(.*?)\s*(:.*)?$/;

/** A program without TigerJython's loops, and what one of its lines has become. */
export interface Unrepeated {
  readonly text: string;
  readonly code: string;
}

/**
 * Writes every `repeat n:` as `for i in range(n):` and every `repeat:` as `while True:`. Loops within loops count with
 * other names, and none with a name that the program has. `null` where a line is not surely such a loop.
 *
 * @param codes the lines without texts and comments
 * @param asked the line, counted from 1, whose new look is given
 */
export function withoutRepeat(lines: readonly string[], codes: readonly string[], asked: number): Unrepeated | null {
  if (codes.some((code) => /^\s*(?:def|class)\s+repeat\b|\brepeat\s*=/.test(code))) return null;
  const free = COUNTERS.filter((name) => !codes.some((code) => new RegExp(`\\b${name}\\b`).test(code)));
  const around: number[] = [];
  const mended = lines.map((line, index) => {
    const code = codes[index] ?? '';
    const indent = code.length - code.trimStart().length;
    if (code.trim() === '') return line;
    while (around.length > 0 && (around.at(-1) ?? 0) >= indent) around.pop();
    const loop = loopOf(line, code, free[around.length]);
    if (loop === null) return line;
    around.push(indent);
    return loop;
  });
  const code = mended[asked - 1];
  if (code === undefined || code === lines[asked - 1]) return null;
  return { text: mended.join('\n'), code: /^\s*((?:for|while)\b[^:]*:)/.exec(code)?.[1] ?? code.trim() };
}

function loopOf(line: string, code: string, name: string | undefined): string | null {
  const found = REPEAT.exec(code);
  if (found === null || /["']/.test(line) || /^\s*repeat\s*[=.,]|^\s*repeat\s*\([^()]*\)\s*$/.test(code)) return null;
  const [, indent = '', written = '', colon] = found;
  if (colon === undefined && (written === '' || line.includes('#'))) return null;
  const tail = colon === undefined ? ':' : line.slice(code.indexOf(colon));
  if (written === '') return `${indent}while True${tail}`;
  const count = /^\(([^()]*)\)$/.exec(written)?.[1] ?? written;
  if (name === undefined || !/^[\w.+\-*/() ]+$/.test(count)) return null;
  return `${indent}for ${name} in range(${count})${tail}`;
}
