import type { Point } from '../src/scene/scene';
import { inWindow } from './arena';
import { expect, type App } from './app';
import { enterMode, isThere, openApp } from './page';
import { by, gone, until } from './parts';

/** Somebody who uses the course editor in one way alone: with fingers, by keyboard or with a mouse. */
export interface Pupil {
  /** Its `click` is that way's own: a finger's tap, Tab and Enter, or a click. */
  readonly app: App;
  chooseTool(tool: string): Promise<void>;
  /** Uses the chosen tool from the first place of the arena (mm), by way of the others, to the last; at one place alone: a tap. */
  draw(places: readonly Point[]): Promise<void>;
}

/** Side of the usual arena, mm. */
export const SIZE: Point = [1200, 900];

/** A tool by its button. */
export const toolButton = (tool: string): string => `[data-tool="${tool}"]`;

/** Begins to build, and waits for the tools. */
export async function build(app: App): Promise<void> {
  await enterMode(app, 'build');
  await until(app, '[data-tool]');
  await until(app, by('course-more'));
}

/** Waits until the code of the tools has come, which the first of them fetches: the arena's cursor shows it. */
export const toolsCame = (app: App): Promise<void> =>
  expect
    .poll(() => app.evaluate((css) => document.querySelector<HTMLElement>(css)?.style.cursor, by('arena')))
    .not.toBe('progress');

/** The pupil with the mouse. */
export const withMouse = (app: App): Pupil => ({
  app,
  async chooseTool(tool) {
    await build(app);
    await app.click(toolButton(tool));
    await toolsCame(app);
  },
  draw: async (places) => app.draw(await inWindow(app, SIZE, places)),
});

/** Opens the page at full speed, and builds. */
export async function openEditor(app: App): Promise<void> {
  await openApp(app, { language: 'en', speed: 'max' });
  await build(app);
}

/**
 * Chooses an entry of a menu, until what it is for has come. A window of WebKit that lies below another one draws nothing for
 * a while: a menu then stands still on its way, and a click can miss it.
 */
export async function fromMenu(app: App, opener: string, entry: string, came: () => Promise<boolean>): Promise<void> {
  await expect(async () => {
    await app.click(opener);
    await until(app, entry);
    await app.click(entry);
    await gone(app, '[role=menu]'); // fading out it still lies over the arena
    await expect.poll(came, { timeout: 3000 }).toBe(true);
  }).toPass();
}

/** Opens a window about the course out of the menu beside undo. */
export async function courseMenu(app: App, panel: string): Promise<void> {
  await build(app);
  await fromMenu(app, by('course-more'), by(`editor-${panel}`), () => isThere(app, by(`panel-${panel}`)));
}

/** Entries of the main menu that stand in one of its lists. */
const LISTED: Readonly<Record<string, string>> = { save: 'save', 'save-program': 'save', 'save-scene': 'save', print: 'save' }; // prettier-ignore

/** Opens the main menu, or one of its lists. */
export async function openMenu(app: App, list?: string): Promise<void> {
  await app.click(by('menu'));
  await until(app, by('menu-help'));
  if (list === undefined) return;
  await app.click(by(`menu-list-${list}`));
  await until(app, by('menu-back'));
}

/** Chooses something in the main menu: `save`, `open`, `teachers` … */
export async function mainMenu(app: App, entry: string): Promise<void> {
  await openMenu(app, LISTED[entry]);
  await until(app, by(`menu-${entry}`));
  await app.click(by(`menu-${entry}`));
  await gone(app, '[role=menu]');
}

/** Opens all settings of the device that is shown. */
export async function openDeviceSettings(app: App): Promise<void> {
  await app.click(by('device'));
  await until(app, by('device-all'));
  await app.click(by('device-all'));
  await until(app, '.device-card');
}

/** Chooses one of the beginnings out of the greeting, which the logo brings back. */
export async function beginWith(app: App, stage: 'board' | 'robot' | 'all'): Promise<void> {
  await app.click(by('logo'));
  await until(app, by(`welcome-${stage}`));
  await app.click(by(`welcome-${stage}`));
  await gone(app, by('welcome'));
}

/** The rows of the list of objects: the robot's start, and everything in the arena. */
export async function listOf(app: App): Promise<readonly string[]> {
  await courseMenu(app, 'list');
  await until(app, `${by('panel-list')} .item`);
  const rows = await rowsIn(app);
  await app.click(`${by('panel-list')} .title button`);
  await gone(app, by('panel-list'));
  return rows;
}

/** The rows of the open list of objects. */
export const rowsIn = (app: App): Promise<readonly string[]> =>
  app.evaluate(() =>
    Array.from(document.querySelectorAll('.objects .item'), (row) =>
      (row.textContent ?? '').replace(/\s+/g, ' ').trim(),
    ),
  );

/** Takes everything out of the arena. The room that the task took goes to the arena. */
export async function clearAll(app: App): Promise<void> {
  await build(app);
  await fromMenu(app, by('course-more'), by('editor-clear'), async () => !(await isThere(app, by('verdict'))));
}

/** True if there is something to take back. */
export const canUndo = (app: App): Promise<boolean> => can(app, 'undo');
export const canRedo = (app: App): Promise<boolean> => can(app, 'redo');

async function can(app: App, what: 'undo' | 'redo'): Promise<boolean> {
  await build(app);
  return isThere(app, `${by(what)}:not([disabled])`);
}
