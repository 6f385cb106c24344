import type { Point } from '../src/scene/scene';
import { expect, type App } from './app';
import { on } from './page';
import { by } from './parts';
import { build, toolButton, toolsCame, type Pupil } from './pupil';

/** More presses than the page has places where the keyboard stops. */
const PLACES = 80;

/** Whether the keyboard is at an element, or in it. */
export const isAt = (app: App, css: string): Promise<boolean> =>
  app.evaluate((selector) => document.activeElement?.closest(selector) !== null, css);

/** Goes on with Tab, or back, until the keyboard is at an element. Out of the editor it goes as the editor says: by Escape. */
export async function tabTo(app: App, css: string, back = false): Promise<void> {
  for (let press = 0; press < PLACES; press += 1) {
    const { isThere, isInCode } = await app.evaluate(
      ({ wish, code }) => ({
        isThere: document.activeElement?.closest(wish) !== null,
        isInCode: document.activeElement?.closest(code) !== null,
      }),
      { wish: css, code: on('editor') },
    );
    if (isThere) return;
    if (isInCode) await app.press('Escape');
    await (back ? app.press('Shift', 'Tab') : app.press('Tab'));
  }
  throw new Error(`Tab does not reach ${css}.`);
}

/** Goes to an element the shorter way. */
async function goTo(app: App, css: string): Promise<void> {
  const isBehind = await app.evaluate((selector) => {
    const [from, to] = [document.activeElement, document.querySelector(selector)];
    if (from === null || from === document.body || to === null) return false;
    return (from.compareDocumentPosition(to) & Node.DOCUMENT_POSITION_PRECEDING) !== 0;
  }, css);
  await tabTo(app, css, isBehind);
}

/** Goes on with an arrow key until the keyboard is at an element: in a menu, in the palette, and among modes. */
async function arrowTo(app: App, css: string, arrow: 'ArrowDown' | 'ArrowRight' | 'ArrowLeft'): Promise<void> {
  for (let press = 0; press < PLACES; press += 1) {
    if (await isAt(app, css)) return;
    await app.press(arrow);
  }
  throw new Error(`The arrow keys do not reach ${css}.`);
}

const isIn = (app: App, css: string, around: string): Promise<boolean> =>
  app.evaluate((of) => (document.querySelector(of.css)?.closest(of.around) ?? null) !== null, { css, around });

/** Like a user who goes to a control by Tab or arrow keys, and presses Enter. */
async function pressAt(app: App, css: string): Promise<void> {
  if (await isIn(app, css, '[role=radiogroup]')) {
    await goTo(app, `[role=radiogroup]:has(${css}) [aria-checked=true]`); // Tab stops at what is chosen
    const isBefore = await isIn(app, css, ':has(~ [aria-checked=true])');
    await arrowTo(app, css, isBefore ? 'ArrowLeft' : 'ArrowRight');
  } else {
    await ((await isIn(app, css, '[role=menu]')) ? arrowTo(app, css, 'ArrowDown') : goTo(app, css));
  }
  if (!(await isAt(app, on('editor')))) await app.press('Enter');
}

/** The pupil with nothing but a keyboard: to use a mouse is an error. */
export function withKeys(plain: App): Pupil {
  const none = (): never => {
    throw new Error('There is only a keyboard.');
  };
  const app: App = {
    ...plain,
    click: (css) => pressAt(plain, css),
    ...{ grab: none, letGo: none, draw: none },
    async fill(css, text) {
      await goTo(plain, css);
      await plain.press('Control', 'a');
      await plain.type(text);
    },
  };
  /** The crosshair, in mm, while the arena has the keyboard. */
  let at: Point | null = null;
  return {
    app,
    async chooseTool(tool) {
      await build(app);
      // Out of the arena by its letter, from elsewhere in the palette.
      if (await isAt(app, on('arena'))) {
        await app.press(LETTERS[tool] ?? '');
      } else {
        await goTo(app, '[data-tool]');
        await arrowTo(app, toolButton(tool), 'ArrowRight');
        await app.press('Enter');
      }
      await expect.poll(() => isChosen(app, tool)).toBe(true);
      await toolsCame(app);
    },
    async draw([first, ...others]) {
      if (first === undefined) return;
      if (!(await isAt(app, on('arena')))) {
        await goTo(app, on('arena'));
        at = null;
      }
      at ??= await crosshair(app);
      // Where one press puts a thing down, a second one would put another.
      const isTap = others.length === 0 && PUT_DOWN.includes(await chosen(app));
      await app.strike([...way(at, [first]), 'Enter', ...way(first, others), ...(isTap ? [] : ['Enter'])]);
      at = others.at(-1) ?? first;
    },
  };
}

const LETTERS: Readonly<Record<string, string>> = {
  pen: 'p',
  maze: 'm',
  wall: 'w',
  block: 'b',
  zone: 'z',
  start: 's',
  select: 'v',
  eraser: 'x',
};

/** Tools that put a thing down with one press. */
const PUT_DOWN = ['block', 'zone', 'label'];

/** The tool that is chosen. */
const chosen = (app: App): Promise<string> =>
  app.evaluate(
    () => document.querySelector<HTMLElement>('[data-tool][aria-pressed="true"]')?.dataset['tool'] ?? '',
    null,
  );

const isChosen = (app: App, tool: string): Promise<boolean> =>
  app.evaluate((css) => document.querySelector(css)?.getAttribute('aria-pressed') === 'true', toolButton(tool));

/** Brings out the crosshair, and hears where it is. */
async function crosshair(app: App): Promise<Point> {
  const said = (): Promise<string> => app.evaluate((css) => document.querySelector(css)?.textContent ?? '', SAID);
  await expect.poll(said).toContain('Arrow keys move the crosshair');
  await app.press('ArrowRight');
  await expect.poll(said).toMatch(/^[\d.]+ \| [\d.]+ cm$/);
  const [x = NaN, y = NaN] = Array.from((await said()).matchAll(/[\d.]+/g), ([cm]) => Number(cm) * 10);
  return [x, y];
}
const SAID = by('arena-said');

/** The arrow keys from one place to the others: steps of 10 mm, each along the side on which there is more to go. */
function way(from: Point, places: readonly Point[]): readonly string[] {
  const keys: string[] = [];
  let [atX, atY] = from;
  for (const [x, y] of places)
    while (atX !== x || atY !== y) {
      const [dx, dy] = [x - atX, y - atY];
      if (Math.abs(dx) >= Math.abs(dy)) {
        keys.push(dx > 0 ? 'ArrowRight' : 'ArrowLeft');
        atX += 10 * Math.sign(dx);
      } else {
        keys.push(dy > 0 ? 'ArrowUp' : 'ArrowDown');
        atY += 10 * Math.sign(dy);
      }
    }
  return keys;
}
