import type { Change } from './change';
import type { Program, ProgramLine } from './program';

/**
 * Says of changes whether they can matter to a run in which only these lines ran: one in a line that was never come to
 * cannot. It says no only where this is sure.
 */
export function mattersTo({ lines }: Program, ran: ReadonlySet<number>): (change: Change) => boolean {
  const never = (line: ProgramLine | undefined): boolean =>
    line !== undefined && isNoted(line) && !ran.has(line.number);
  const before = (number: number, indent: number): ProgramLine | undefined =>
    lines.slice(0, number - 1).findLast((line) => isCode(line) && line.indent.length <= indent);
  return ({ line, before: gone, after, kind }) => {
    const indent = indentOf(after[0] ?? '');
    if (gone.length === 0) {
      const [next, last] = [lines[line - 1], before(line, indent)];
      if (next?.indent.length === indent && never(next)) return false;
      return last?.kind !== 'simple' || last.indent.length !== indent || !never(last);
    }
    const touched = lines.slice(line - 1, line - 1 + gone.length);
    if (!touched.every(never)) return true;
    if (kind === 'indent') return !never(before(line, indent));
    // A branch of its own is come to where one of several was not.
    return kind === 'logic' && BRANCH.exec(gone[0] ?? '')?.[0] !== BRANCH.exec(after[0] ?? '')?.[0];
  };
}

const BRANCH = /^\s*(if|elif|while)\b/;

const indentOf = (text: string): number => /^[ \t]*/.exec(text)?.[0].length ?? 0;

const isCode = ({ text }: ProgramLine): boolean => !/^\s*(#|$)/.test(text);

/** True if the VM tells when it comes to a line: not of what needs no work, nor of statements over several lines. */
const isNoted = ({ kind, text, code }: ProgramLine): boolean =>
  kind === 'head'
    ? /^\s*(if|elif|while|for)\b(?!\s*\(?(True|False|\d+)\)?\s*:)/.test(text)
    : kind === 'simple' && !/^(pass|global|nonlocal|["'\d]|[A-Za-z_]\w*$)/.test(code);
