import type { ArenaTool } from '../state/course-editor-model';

/** The tools in the order of the palette, in groups that belong together. */
export const toolGroups = {
  move: ['hand', 'select', 'rotate', 'ruler'],
  draw: ['pen', 'eraser', 'maze', 'label'],
  put: ['block', 'wall', 'zone', 'start'],
} as const satisfies Readonly<Record<string, readonly PaletteTool[]>>;
export type ToolGroup = keyof typeof toolGroups;

/** A tool that the palette shows; the other one bends a line that is selected. */
export type PaletteTool = Exclude<ArenaTool, 'points'>;

/** All tools, in that order. */
export const allTools: readonly PaletteTool[] = Object.values(toolGroups).flat();

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
  allTools.find((tool) => toolLetters[tool] === letter);
