import type { Point } from '#scene/scene';

import { blocksOf } from '../../../session/task/markup';
import type { PaperBlock, Paragraph, Sign } from './set-rows';

/** The task of a course as it is printed: every sentence in the language of the reader. */
export interface PaperTask {
  readonly title: string;
  /** In the small markup of tasks. */
  readonly text: string;
  /** Its picture in a form for PDF, and its size in pixels. */
  readonly picture: { readonly data: string; readonly format: 'PNG' | 'JPEG'; readonly size: Point } | null;
  readonly goalsTitle: string;
  /** Goals and rules. */
  readonly goals: readonly string[];
  readonly rules: readonly string[];
  /** Title over the further checks; without any it is not printed. */
  readonly checksTitle: string;
  readonly checks: readonly string[];
  /** The conditions for one star, two, three. Empty: there are none. */
  readonly stars: readonly string[];
  /** Empty: none are printed. */
  readonly hints: readonly { readonly title: string; readonly text: string }[];
}

/** Type size of a text on paper, in mm: 12 pt, for children who have just learnt to read. */
export const TEXT_MM = 4.25;

/** A picture has the size that it has on a screen, as far as there is room: 96 pixels an inch. */
const MM_PER_PX = 25.4 / 96;
const HIGHEST_MM = 110;

/** Sizes and indents below are in parts of the text's type size. */
const TITLE = 1.7;
const HEADING = 1.15;
const INDENT = 1.6;
const STARS_INDENT = 4.2;

/** The blocks of the task's sheet, in the order of the card. @param em its type size in mm */
export function taskBlocks(task: PaperTask, widthMm: number, em = TEXT_MM): readonly PaperBlock[] {
  const entries = (texts: readonly string[], indent: number, signOf: (index: number) => Sign): Paragraph[] =>
    texts.map((text, index) => ({
      ...plain(text, em),
      indentMm: indent * em,
      sign: signOf(index),
      aboveMm: (index === 0 ? 0.6 : 0.25) * em,
      staysWithNext: index < texts.length - 1,
    }));
  const mark = (): Sign => ({ kind: 'mark', text: '•' });
  const checks = entries(task.checks, INDENT, mark);
  const goals = [
    ...entries(task.goals, INDENT, () => ({ kind: 'ring' })),
    ...entries(task.rules, INDENT, mark),
    ...entries(task.stars, STARS_INDENT, (index) => ({ kind: 'stars', count: index + 1 })),
  ];
  return [
    ...titleBlock(task.title, em),
    ...textBlocks(task.text, em, task.picture === null ? null : pictureSize(task.picture.size, widthMm)),
    ...(goals.length === 0 ? [] : [heading(task.goalsTitle, em), ...goals]),
    ...(checks.length === 0 ? [] : [heading(task.checksTitle, em), ...checks]),
    ...task.hints.flatMap(({ title, text }) => [heading(title, em), ...textBlocks(text, em, null)]),
  ];
}

/** The title as a block, if there is one. */
export const titleBlock = (title: string, em: number): readonly Paragraph[] =>
  title === '' ? [] : [{ ...bold(title, TITLE * em), aboveMm: 0, staysWithNext: true }];

/** A text in the markup of tasks. The picture stands where the text has a place for it, otherwise at its end. */
export function textBlocks(text: string, em: number, picture: Point | null): readonly PaperBlock[] {
  const blocks = blocksOf(text);
  const hasPlace = blocks.some(({ kind }) => kind === 'picture');
  const pictureBlock = picture === null ? [] : [{ kind: 'picture', size: picture, aboveMm: 0.9 * em } as const];
  const set = blocks.flatMap((block): readonly PaperBlock[] => {
    if (block.kind === 'picture') return pictureBlock;
    if (block.kind === 'text') return [{ ...plain('', em), lines: block.lines, aboveMm: 0.7 * em }];
    return block.lines.map((line, index) => ({
      ...plain('', em),
      lines: [line],
      indentMm: INDENT * em,
      sign: { kind: 'mark', text: block.kind === 'list' ? '•' : `${String(index + 1)}.` },
      aboveMm: (index === 0 ? 0.5 : 0.2) * em,
      // No entry stays alone at the foot or at the head of a page.
      staysWithNext: index < block.lines.length - 1 && (index === 0 || index === block.lines.length - 2),
    }));
  });
  return hasPlace ? set : [...set, ...pictureBlock];
}

/** As large as on a screen, smaller where it would not fit. */
function pictureSize([width, height]: Point, roomMm: number): Point {
  const scale = Math.min(MM_PER_PX, roomMm / width, HIGHEST_MM / height);
  return [width * scale, height * scale];
}

/** A plain paragraph: no indent, no sign, no room above it. */
export const plain = (text: string, sizeMm: number): Paragraph => ({
  ...{ kind: 'words', lines: [[{ kind: 'text', text }]], sizeMm },
  ...{ indentMm: 0, sign: null, aboveMm: 0, staysWithNext: false },
});

const bold = (text: string, sizeMm: number): Paragraph => ({
  ...plain('', sizeMm),
  lines: [[{ kind: 'bold', text }]],
});

/** A heading over what comes next. */
export const heading = (text: string, em: number): Paragraph => ({
  ...{ ...bold(text, HEADING * em), aboveMm: 1.5 * em, staysWithNext: true },
});
