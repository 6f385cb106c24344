import { pythonLanguage } from '@codemirror/lang-python';
import { highlightCode, tagHighlighter, tags } from '@lezer/highlight';

/** A piece of a line, and its sort for the colours (`ProgramText.vue`); empty: none. */
export type Part = readonly [text: string, sort: string];

const sorts = tagHighlighter([
  { tag: [tags.keyword, tags.operatorKeyword, tags.modifier], class: 'kw' },
  { tag: tags.string, class: 'str' },
  { tag: tags.comment, class: 'com' },
  { tag: [tags.number, tags.bool, tags.null, tags.self], class: 'num' },
  { tag: [tags.function(tags.variableName), tags.function(tags.propertyName)], class: 'fn' },
]);

/** The lines of a program in pieces, as the editor colours them. */
export function programParts(text: string): readonly (readonly Part[])[] {
  const lines: Part[][] = [[]];
  const put = (part: string, sort: string): void => void lines.at(-1)?.push([part, sort]);
  highlightCode(text, pythonLanguage.parser.parse(text), sorts, put, () => lines.push([]));
  return lines;
}
