/** The kinds of small changes. */
export const hintKinds = [
  ...(['number', 'name', 'comparison', 'logic', 'missing', 'indent', 'order', 'extra', 'polarity'] as const),
] as const;
export type HintKind = (typeof hintKinds)[number];

/** A small change to a program: at most two whole lines for at most two others. */
export interface Change {
  readonly kind: HintKind;
  /** Number of its first line, from 1; an insertion stands before this line. */
  readonly line: number;
  /** The lines that go; none: an insertion. */
  readonly before: readonly string[];
  /** The lines that come in their place. */
  readonly after: readonly string[];
  /** True of numbers only: whether it becomes greater or less. */
  readonly direction: 'more' | 'less' | null;
}

/** The lines of a text. */
export const linesOf = (text: string): readonly string[] => text.split(/\r\n?|\n/);

/** A text after a change. */
export function withChange(text: string, { line, before, after }: Change): string {
  const lines = linesOf(text);
  return [...lines.slice(0, line - 1), ...after, ...lines.slice(line - 1 + before.length)].join('\n');
}

/** The lines of a program in which a change is to be looked for. */
export function linesToSee({ line, before }: Change, text: string): readonly number[] {
  if (before.length > 0) return before.map((_, place) => line + place);
  const count = linesOf(text.trimEnd()).length;
  return [line - 1, line].filter((one) => one >= 1 && one <= count);
}
