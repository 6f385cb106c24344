import type { Settings } from '../src/web/session/work/settings/settings';
import { openedCourse } from './opened-course';
import { expect, type App } from './app';

/** The things that tests touch. */
const PLACES = {
  run: 'button.run',
  stop: 'button.stop',
  reset: 'button[aria-label="Back to the start"], button[aria-label="Zurück auf Start"]',
  console: '[role=log]',
  editor: '.code-editor .cm-content',
  arena: '[role=application]',
} as const;

/** Selector of a thing on the page. */
export const on = (name: keyof typeof PLACES): string => PLACES[name];

const EDITOR = on('editor');
const EDITOR_BOX = '.code-editor .cm-scroller';

/**
 * Opens the app and waits until a program can be typed; `settings` are those of an earlier visit that left the closed line
 * open with its card folded, unless nobody was greeted in it.
 */
export async function openApp(app: App, settings: Partial<Settings> = {}): Promise<void> {
  if (Object.keys(settings).length > 0) {
    await app.goto('./logo.svg'); // its storage is the app's, and it loads in no time
    await app.evaluate(
      (kept) => {
        localStorage.setItem('parcours.settings', kept.settings);
        if (kept.work !== '') sessionStorage.setItem('parcours.work', kept.work);
      },
      {
        settings: JSON.stringify({ showCard: settings.welcomed === false, ...settings }),
        work: settings.welcomed === false ? '' : closedLine(),
      },
    );
  }
  await app.goto('./');
  await expect.poll(() => app.evaluate((css) => document.querySelector(css) !== null, EDITOR)).toBe(true);
}

/** Opens the page with the work of an earlier visit. @param address what stands behind the page's: `./#task` */
export async function openWork(app: App, work: string, address = './'): Promise<void> {
  await app.goto('./logo.svg'); // its storage is the app's, and it loads in no time
  await app.evaluate((kept) => sessionStorage.setItem('parcours.work', kept), work);
  await app.goto(address);
}

/** The closed line as somebody has it open who was here before. */
export const closedLine = (): string => openedCourse('closed-line');

/** Replaces the program in the editor by typing, line by line: the editor's own indentation is typed over. */
export async function typeProgram(app: App, source: string): Promise<void> {
  await app.click(EDITOR_BOX); // the middle of the text itself may lie beyond the pane, where WebKit clicks nothing
  await app.press('Control', 'a');
  await app.press('Delete');
  for (const [place, line] of source.split('\n').entries()) {
    if (place > 0) {
      await app.press('Escape'); // no suggestion takes the Enter
      await app.press('Enter');
      await app.press('Shift', 'Home');
      await app.press('Delete');
    }
    await app.type(line);
  }
  await expect.poll(() => programIn(app)).toBe(source);
}

/** Replaces the program in the editor by pasting, as from a worksheet: quick, and without the editor's own indentation. */
export async function pasteProgram(app: App, source: string): Promise<void> {
  if ((await modeOf(app)) === 'build') await enterMode(app, 'drive'); // building has no program in sight
  await app.click(EDITOR_BOX);
  await app.press('Control', 'a');
  await app.evaluate(
    ({ css, text }) => {
      const event = new Event('paste', { bubbles: true, cancelable: true });
      Object.defineProperty(event, 'clipboardData', { value: { getData: () => text } });
      document.querySelector(css)?.dispatchEvent(event);
    },
    { css: EDITOR, text: source },
  );
  await expect.poll(() => programIn(app)).toBe(source);
}

/** True if something is on the page. */
export const isThere = (app: App, css: string): Promise<boolean> =>
  app.evaluate((selector) => document.querySelector(selector) !== null, css);

/** The value of an attribute of the first such element; `null` without element or attribute. */
export const attribute = (app: App, css: string, name: string): Promise<string | null> =>
  app.evaluate((of) => document.querySelector(of.css)?.getAttribute(of.name) ?? null, { css, name });

/** The robot of the device that is shown, by the device's button, which may cut it off or show none of it. */
export const robotName = async (app: App): Promise<string | undefined> =>
  /: ([^,]+),/.exec((await attribute(app, '[data-testid="device"]', 'aria-label')) ?? '')?.[1];

type ArenaMode = 'drive' | 'build' | 'lookBack';

/** The mode of the arena; `null`: there is just one, or the arena is out of sight. */
const modeOf = async (app: App): Promise<string | null> =>
  (await attribute(app, '[data-testid^="mode-"][aria-checked="true"]', 'data-testid'))?.replace('mode-', '') ?? null;

/** Enters a mode of the arena, unless it is the present one. */
export async function enterMode(app: App, mode: ArenaMode): Promise<void> {
  const button = `[data-testid="mode-${mode}"]`;
  await expect.poll(() => isThere(app, button)).toBe(true);
  if ((await modeOf(app)) === mode) return;
  await app.click(button);
  await expect.poll(() => modeOf(app)).toBe(mode);
}

/** The text in the editor, all of it: of a long one the page holds only the lines near those in sight. */
export function programIn(app: App): Promise<string> {
  return app.evaluate((css) => {
    type Tile = { readonly root: { readonly view: { readonly state: { readonly doc: { toString(): string } } } } };
    const content: (Element & { readonly cmTile?: Tile }) | null = document.querySelector(css);
    if (content === null) return '';
    if (content.cmTile === undefined) throw new Error('The editor keeps its text elsewhere than under cmTile.');
    return content.cmTile.root.view.state.doc.toString();
  }, EDITOR);
}

/** The robot's place in the arena's words. */
export interface Shown {
  readonly xMm: number;
  readonly yMm: number;
  readonly headingDeg: number;
}

/** The robot's place, as the arena reports it. */
export function robotIn(app: App): Promise<Shown> {
  return app.evaluate((css) => {
    const said = document.querySelector(`${css} p:last-of-type`)?.textContent ?? '';
    const [x, y, heading] = Array.from(said.matchAll(/-?[\d.]+/g), Number);
    return { xMm: 10 * (x ?? NaN), yMm: 10 * (y ?? NaN), headingDeg: heading ?? NaN };
  }, on('arena'));
}

/**
 * The console's text, one entry below the other, including what is scrolled out of view, which engines leave out of
 * `text`.
 */
export const consoleIn = (app: App): Promise<string> =>
  app.evaluate(
    (css) => Array.from(document.querySelector(css)?.children ?? [], ({ textContent }) => textContent).join('\n'),
    on('console'),
  );

/**
 * Keeps something down until the program has seen it. Once more where that fails: a window of another test that opens
 * takes the focus away, and the page then lets go of everything, as it should.
 */
export async function keepDown(
  app: App,
  by: { down(): Promise<void>; up(): Promise<void> },
  seen: string,
): Promise<void> {
  await expect(async () => {
    await by.down();
    try {
      await expect.poll(() => consoleIn(app), { timeout: 3000 }).toContain(seen);
    } finally {
      await by.up();
    }
  }).toPass();
}

/** True if a button can be pressed. */
export function isEnabled(app: App, name: keyof typeof PLACES): Promise<boolean> {
  return app.evaluate((css) => document.querySelector<HTMLButtonElement>(css)?.disabled === false, on(name));
}
