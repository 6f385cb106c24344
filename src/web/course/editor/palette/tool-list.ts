import type { ArenaTool } from '../state/course-editor-model';

/** The tools in the order of the palette, in groups that belong together. */
export const toolGroups: readonly (readonly PaletteTool[])[] = [
  ['hand', 'select', 'rotate'],
  ['pen', 'eraser'],
  ['block', 'wall', 'maze'],
  ['zone', 'label'],
  ['start', 'ruler'],
];

/** A tool that the palette shows; the other one bends a line that is selected. */
export type PaletteTool = Exclude<ArenaTool, 'points'>;

/** The letter that chooses a tool while the arena or the palette has the focus. */
export const toolLetters: Readonly<Record<PaletteTool, string>> = {
  hand: 'h',
  select: 'v',
  rotate: 'r',
  pen: 'p',
  eraser: 'x',
  block: 'b',
  wall: 'w',
  maze: 'm',
  zone: 'z',
  label: 't',
  start: 's',
  ruler: 'l',
};

/** The tool that a letter chooses. */
export const toolOfLetter = (letter: string): PaletteTool | undefined =>
  toolGroups.flat().find((tool) => toolLetters[tool] === letter);
