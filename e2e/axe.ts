import { createRequire } from 'node:module';
import type { App } from './app';

/** The copy of axe that comes with Playwright's binding, which itself cannot drive WebKitGTK. */
const { source } = createRequire(createRequire(import.meta.url).resolve('@axe-core/playwright'))('axe-core') as {
  readonly source: string;
};

interface Violation {
  readonly id: string;
  readonly nodes: readonly { readonly target: readonly string[] }[];
}

interface WithAxe {
  readonly axe?: { run(options: object): Promise<{ readonly violations: readonly Violation[] }> };
}

/** The violations that axe finds on the page: one line for each rule, with the places. */
export const violationsOn = (app: App): Promise<readonly string[]> => violationsBy((code) => app.evaluate(code));

/** The same in the page of a frame. */
export const violationsIn = (app: App, frame: string): Promise<readonly string[]> =>
  violationsBy((code) => app.inFrame(frame, code));

/** The same by any way to run code in a page. */
export async function violationsBy(
  evaluate: <R>(code: string | (() => R | Promise<R>)) => Promise<R>,
): Promise<readonly string[]> {
  if (!(await evaluate(() => 'axe' in window))) await evaluate(`(() => { ${source} })()`);
  const violations = await evaluate(async () => {
    // What has just come begins to fade in with the next picture.
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    // What fades in or out would be judged by a colour that is gone in a moment.
    const running = document.getAnimations().filter(({ effect }) => effect?.getComputedTiming().endTime !== Infinity);
    await Promise.all(running.map(({ finished }) => finished.catch(() => null)));
    const found = await (window as WithAxe).axe?.run({ resultTypes: ['violations'] });
    return found?.violations.map(({ id, nodes }) => ({ id, nodes: nodes.map(({ target }) => ({ target })) })) ?? [];
  });
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}
