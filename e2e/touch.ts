import type { Page } from '@playwright/test';
import { inWindow } from './arena';
import { playwrightApp, type App, type Place } from './app';
import { build, SIZE, toolButton, toolsCame, type Pupil } from './pupil';

/** A tablet held upright. */
export const tablet = { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true } as const;

/** Time between two places of a finger that draws, in ms: about what a tablet reports. */
const MOVE_MS = 16;

/** Number of places that a finger reports while it comes to rest. */
const RESTS = 8;

/** Fingers on a touch screen, in Chromium alone: its protocol sends real touches, from which the page gets pointer events. */
export interface Fingers {
  /** One finger on the middle of an element. */
  tap(css: string): Promise<void>;
  tapAt(place: Place): Promise<void>;
  /** One finger goes down at the first place, by way of the others, and up at the last. */
  draw(places: readonly Place[]): Promise<void>;
  /** Two fingers at once, each along its places. The other comes down when the first is at its place number `late`. */
  drawTwo(one: readonly Place[], other: readonly Place[], late?: number): Promise<void>;
  /** One finger goes down on the middle of an element and stays there until `lift`. */
  rest(css: string): Promise<void>;
  lift(): Promise<void>;
}

/** @param page of a context with `hasTouch` */
export async function fingersOn(page: Page): Promise<Fingers> {
  const session = await page.context().newCDPSession(page);
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', places: readonly Place[]): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(({ x, y }, id) => ({ x, y, id })) });
  const along = async (ways: readonly (readonly Place[])[], late = 0): Promise<void> => {
    const steps = ways[0]?.length ?? 0;
    const at = (step: number): Place[] => ways.flatMap((way, i) => way[step - i * late] ?? []);
    await send('touchStart', at(0));
    for (let step = 1; step < steps; step += 1) {
      await page.waitForTimeout(MOVE_MS);
      await send(at(step).length > at(step - 1).length ? 'touchStart' : 'touchMove', at(step));
    }
    // Fingers come to rest: those that leave in full swing make the browser take the next tap for what stops the swing.
    for (let rest = 0; rest < RESTS; rest += 1) {
      await page.waitForTimeout(MOVE_MS);
      await send('touchMove', at(steps - 1).map(({ x, y }) => ({ x: x + ((rest + 1) % 2), y }))); // prettier-ignore
    }
    await send('touchEnd', []);
  };
  return {
    tap: (css) => page.tap(css),
    // One touch without a rest: on a busy machine a longer one would be a finger that rests, and open a menu.
    tapAt: ({ x, y }) => page.touchscreen.tap(x, y),
    draw: (places) => along([places]),
    drawTwo: (one, other, late) => along([one, other], late),
    async rest(css) {
      const box = await page.locator(css).boundingBox();
      if (box === null) throw new Error(`There is no ${css}.`);
      await send('touchStart', [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }]);
    },
    async lift() {
      await send('touchEnd', []);
    },
  };
}

/** The pupil with nothing but fingers: to press a key or to use a mouse is an error. */
export async function withFingers(page: Page): Promise<Pupil & { readonly fingers: Fingers }> {
  const fingers = await fingersOn(page);
  const none = (): never => {
    throw new Error('There are only fingers.');
  };
  const app: App = {
    ...playwrightApp('chromium', page),
    click: (css) => fingers.tap(css),
    press: async (...keys) => {
      if (keys.join('+') !== 'Control+a') none();
      await page.evaluate(async () => {
        // As by the menu that a tablet shows at the text; the editor hears of it a moment later.
        const heard = new Promise((resolve) => {
          document.addEventListener('selectionchange', resolve, { once: true });
          setTimeout(resolve, 500); // all was selected before
        });
        if (document.activeElement !== null) getSelection()?.selectAllChildren(document.activeElement);
        await heard;
        for (let frame = 0; frame < 3; frame += 1) await new Promise(requestAnimationFrame);
      });
    },
    ...{ type: none, hold: none, release: none, grab: none, letGo: none },
    async draw(places) {
      const [only] = places;
      await (places.length === 1 && only !== undefined ? fingers.tapAt(only) : fingers.draw(places));
    },
  };
  return {
    app,
    fingers,
    async chooseTool(tool) {
      await build(app);
      await fingers.tap(toolButton(tool));
      await toolsCame(app);
    },
    draw: async (places) => fingers.draw(await inWindow(app, SIZE, places)),
  };
}
