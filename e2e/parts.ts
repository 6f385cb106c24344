import { expect, type App } from './app';
import { isThere } from './page';

/** Selector of a part of the page by the name it has for tests. */
export const by = (id: string): string => `[data-testid="${id}"]`;

/** Waits until it is there. */
export const until = (app: App, css: string): Promise<void> => expect.poll(() => isThere(app, css)).toBe(true);

/** Waits until it is gone. */
export const gone = (app: App, css: string): Promise<void> => expect.poll(() => isThere(app, css)).toBe(false);

/** Opens a panel of the board, which has them where it is whole: beside a card it is small. */
export async function openPanel(app: App, panel: 'sensors' | 'radio' | 'log'): Promise<void> {
  const [whole, button] = [by('board-whole'), by(`panel-${panel}`)];
  await until(app, `${whole}, ${button}`);
  if (await isThere(app, whole)) await app.click(whole);
  await app.click(button);
}

/** As a hand at a select: the browsers' own lists are no part of the page. */
export const choose = (app: App, option: string, value: string): Promise<void> =>
  app.evaluate(
    (wish) => {
      const select = document.querySelector<HTMLSelectElement>(wish.css);
      if (select === null) throw new Error(`There is no ${wish.css}.`);
      select.value = wish.value;
      select.dispatchEvent(new Event('change', { bubbles: true }));
    },
    { css: by(`option-${option}`), value },
  );
