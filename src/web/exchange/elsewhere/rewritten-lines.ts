import type { RewrittenLine } from '#intake/document';
import type { SourceFile } from '#project/project';

/**
 * The lines of a program that still are as they were written when it was opened, where they stand now. Where lines came
 * or went, those before and behind the change are known.
 */
export function linesStillThere(
  opened: readonly SourceFile[],
  now: readonly SourceFile[],
  rewritten: readonly RewrittenLine[],
): readonly RewrittenLine[] {
  const linesOf = (files: readonly SourceFile[], name: string): readonly string[] =>
    files.find((file) => file.name === name)?.text.split('\n') ?? [];
  return rewritten.flatMap((one) => {
    const lines = linesOf(now, one.file);
    const line = placeNow(linesOf(opened, one.file), lines, one.line);
    return lines[line - 1] === one.after ? [{ ...one, line }] : [];
  });
}

/** The number of a line after others came or went; 0: unknown. */
function placeNow(before: readonly string[], now: readonly string[], line: number): number {
  if (before.length === now.length) return line;
  const shorter = Math.min(before.length, now.length);
  let same = 0;
  while (same < shorter && before[same] === now[same]) same += 1;
  if (line <= same) return line;
  let behind = 0;
  while (behind < shorter - same && before.at(-1 - behind) === now.at(-1 - behind)) behind += 1;
  return line > before.length - behind ? line + now.length - before.length : 0;
}
