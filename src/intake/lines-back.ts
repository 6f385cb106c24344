import type { SourceFile } from '#project/project';
import type { RewrittenLine } from './document';

/** A file with these lines as they were before they were rewritten. */
export function withLinesBack({ name, text }: SourceFile, rewritten: readonly RewrittenLine[]): SourceFile {
  const lines = text.split('\n');
  for (const { file, line, before } of rewritten) if (file === name) lines[line - 1] = before;
  return { name, text: lines.join('\n') };
}
