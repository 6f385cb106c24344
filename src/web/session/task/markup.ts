/**
 * The small markup of tasks and hints: paragraphs separated by an empty line, `- ` and `1. ` lists, `**bold**`,
 * `` `code` ``, and `![words](picture)` for the place of the task's picture. All else is text: no links, no HTML. The
 * result is data, from which `MarkupText.vue` makes elements, so nothing that a teacher or a stranger has written is
 * ever read as HTML.
 */

/** A part of a line. */
export interface Span {
  readonly kind: 'text' | 'bold' | 'code';
  readonly text: string;
}

/** A line or a list entry. */
export type Line = readonly Span[];

/** A paragraph with its lines, a list with its entries, or the place of the picture with its description. */
export type Block =
  | { readonly kind: 'text' | 'list' | 'numbers'; readonly lines: readonly Line[] }
  | { readonly kind: 'picture'; readonly words: string };

const BULLET = /^\s*[-*•] +/;
const NUMBER = /^\s*\d{1,3}[.)] +/;
const PICTURE = /^!\[([^\]]*)\]\(picture\)$/;

/** Reads a text; every text can be read. */
export function blocksOf(text: string): readonly Block[] {
  const blocks: Block[] = [];
  /** The lines of the last block, which grow: a text may have thousands. */
  let lines: Line[] = [];
  let isNew = true;
  for (const line of text.split(/\r?\n/)) {
    const trimmed = line.trim();
    const picture = PICTURE.exec(trimmed);
    if (picture !== null) blocks.push({ kind: 'picture', words: picture[1] ?? '' });
    if (trimmed === '' || picture !== null) {
      isNew = true;
      continue;
    }
    const kind = BULLET.test(line) ? 'list' : NUMBER.test(line) ? 'numbers' : 'text';
    const before = blocks.at(-1);
    const spans = spansOf(kind === 'text' ? trimmed : line.replace(kind === 'list' ? BULLET : NUMBER, ''));
    if (!isNew && before?.kind === kind) lines.push(spans);
    else blocks.push({ kind, lines: (lines = [spans]) });
    isNew = false;
  }
  return blocks;
}

/** The parts of a line: a mark without its second half is text. */
export function spansOf(line: string): Line {
  const spans: Span[] = [];
  let rest = line;
  while (rest !== '') {
    const mark = /`([^`]+)`|\*\*(?=\S)([^*]+)\*\*/.exec(rest);
    const before = mark === null ? rest : rest.slice(0, mark.index);
    if (before !== '') spans.push({ kind: 'text', text: before });
    if (mark === null) break;
    const [whole, code, bold] = mark;
    spans.push(code === undefined ? { kind: 'bold', text: bold ?? '' } : { kind: 'code', text: code });
    rest = rest.slice(mark.index + whole.length);
  }
  return spans;
}
