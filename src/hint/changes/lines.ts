import { parsePython, readPython } from '#python/tree';
import { linesOf, withChange, type Change } from './change';
import type { Program, ProgramLine } from './program';

/** A line less. One that is alone in its block gives way to `pass`. */
export const extraChanges = (program: Program): readonly Change[] =>
  simple(program).flatMap(({ number: line, text, indent }) => {
    const without = (after: readonly string[]): Change => ({ ...plain('extra', line), before: [text], after });
    return firstRight(program, [without([]), without([`${indent}pass`])]);
  });

/** Two neighbours of one block in the other order. */
export const orderChanges = (program: Program): readonly Change[] =>
  program.lines.flatMap((line, place) => {
    const next = program.lines[place + 1];
    if (line.kind !== 'simple' || next?.kind !== 'simple' || line.indent !== next.indent) return [];
    if (line.code === next.code || [line, next].some(isImport)) return [];
    return [{ ...plain('order', line.number), before: [line.text, next.text], after: [next.text, line.text] }];
  });

/** A line, or two, one level further in or out, or as far in as the lines beside it. */
export function indentChanges(program: Program): readonly Change[] {
  const { lines } = program;
  const step = stepOf(program);
  return lines.flatMap((line, place) => {
    if (line.text.trim() === '' || line.text.trim().startsWith('#') || isImport(line)) return [];
    const next = lines[place + 1];
    const before = lines.slice(0, place).findLast(({ text }) => text.trim() !== '');
    const beside = [before?.indent ?? '', next?.indent ?? '', `${before?.indent ?? ''}${step}`];
    const out = line.indent.length >= step.length ? [line.indent.slice(step.length)] : [];
    // The first line of a block further in is the same block.
    const inwards =
      before?.kind === 'head' && line.indent.length > before.indent.length ? [] : [`${line.indent}${step}`];
    const indents = [...inwards, ...out, ...(line.indent.length % step.length === 0 ? [] : beside)];
    return [...new Set(indents)].flatMap((indent) => {
      if (indent === line.indent) return [];
      const moved = ({ text }: ProgramLine): string => indent + text.slice(line.indent.length);
      const one = { ...plain('indent', line.number), before: [line.text], after: [moved(line)] };
      const isTwo = next?.kind === 'simple' && next.indent === line.indent;
      const two = isTwo && { ...one, before: [line.text, next.text], after: [moved(line), moved(next)] };
      return [one, ...(two ? [two] : [])];
    });
  });
}

/** The spaces of one level, as the program has them. */
export const stepOf = ({ lines }: Program): string =>
  lines.map(({ indent }) => indent).find((indent) => indent !== '') ?? '    ';

/** The parts of a change that lines have in common. */
export const plain = (kind: Change['kind'], line: number) => ({ kind, line, direction: null });

/** The statements that stand in one line, without imports. */
export const simple = ({ lines }: Program): readonly ProgramLine[] =>
  lines.filter((line) => line.kind === 'simple' && !isImport(line) && line.code !== '');

/** True for an import. */
export const isImport = ({ statement }: ProgramLine): boolean => statement === 'ImportStatement';

/** True if a text is a program by its syntax and its indentation. */
export const isWellFormed = (text: string): boolean => !parsePython(text).hasErrors && !isBroken(text);

/** True if a change makes no new mistake of syntax. */
export function isRight({ source }: Program, change: Change): boolean {
  const text = withChange(source.text, change);
  return (source.hasErrors || !readPython(text).hasErrors) && (!isBroken(text) || isBroken(source.text));
}

/** True if a block is empty or a line stands further in than its block: the parser does not see that. */
function isBroken(text: string): boolean {
  const levels = [0];
  let opens = false;
  for (const line of linesOf(text)) {
    const code = line.replace(/#.*$/, '').trimEnd();
    if (code.trim() === '') continue;
    const width = /^[ \t]*/.exec(code)?.[0].length ?? 0;
    const top = levels.at(-1) ?? 0;
    if (opens !== width > top) return true;
    if (opens) levels.push(width);
    while ((levels.at(-1) ?? 0) > width) levels.pop();
    if (levels.at(-1) !== width) return true;
    opens = code.endsWith(':');
  }
  return opens;
}

const firstRight = (program: Program, changes: readonly Change[]): readonly Change[] =>
  changes.filter((change) => isRight(program, change)).slice(0, 1);
