import { expect, test, type App } from './app';
import { CREEP, linkTo, openClass, paste, RIGHT } from './class-page';
import { microbitHost, type SimulatorOfHost } from './hosts/microbit/microbit-host';
import { appAddress } from './hosts';
import { oldChromiums, openOldChromium, type OldPage } from './old-chromium';
import { closedLine, on, openApp, openWork } from './page';
import { by, until } from './parts';

/** The robot's place in mm from the left, as the arena reports it. */
const robotX = (app: App): Promise<number> =>
  app.evaluate(() => {
    const said = document.querySelector('[role=application] p:last-of-type')?.textContent ?? '';
    return 10 * Number(/-?[\d.]+/.exec(said)?.[0]);
  });

async function drives(app: App): Promise<void> {
  await until(app, on('editor'));
  const before = await robotX(app);
  await app.click(on('run'));
  await expect.poll(() => robotX(app)).not.toBe(before);
}

const choose = (app: App, id: string, value: string): Promise<void> =>
  app.evaluate(
    (wish) => {
      const list = document.querySelector<HTMLSelectElement>(`[data-testid=${wish.id}]`);
      if (list === null) throw new Error(`There is no ${wish.id}.`);
      list.value = wish.value;
      list.dispatchEvent(new Event('change', { bubbles: true }));
    },
    { id, value },
  );

/** The oldest browsers: features they lack are lowered, filled in or done without, so the whole page works there. */
const programs = oldChromiums();
if (programs.length === 0) test.skip('an old Chromium runs the page', () => undefined); // none could be fetched

for (const program of programs) {
  const name = /chromium-\d+/.exec(program)?.[0] ?? program;
  test.describe(name, () => {
    let old: OldPage;
    test.beforeEach(async () => {
      old = await openOldChromium(program);
    });
    test.afterEach(async () => {
      await old.close();
      expect(old.faults).toEqual([]);
    });

    test('runs a program that drives', async () => {
      expect(name).toBe(`chromium-${old.version.split('.')[0] ?? ''}`);
      await openWork(old.app, closedLine());
      await drives(old.app);
    });

    test('has the page fill the window, its buttons in their form and its menus', async () => {
      await openApp(old.app, { welcomed: true });
      const form = await old.app.evaluate(() => {
        const style = (css: string) => getComputedStyle(document.querySelector(css)!);
        return {
          app: document.querySelector('.app')!.getBoundingClientRect().height,
          button: style('button.run').display,
          icon: Number.parseFloat(style('button.run svg').width),
        };
      });
      expect(form).toMatchObject({ app: 800, button: 'flex' });
      expect(form.icon).toBeLessThan(40);
    });

    test('runs the single file', async () => {
      await old.app.goto('./parcours.single.html');
      await drives(old.app);
    });

    test('checks a class', async () => {
      await openClass(old.app, 'closed-line');
      await paste(old.app, `Ada: ${linkTo(RIGHT)}\nBen: ${linkTo(CREEP)}`);
      await until(old.app, by('class-table'));
      await expect.poll(() => old.app.text(by('class-table')), { timeout: 40_000 }).toMatch(/Ben\W+nicht bestanden/);
      expect(await old.app.text(by('class-table'))).toMatch(/Ada\W+bestanden/);
    });

    test('makes a series and opens it by its link', async () => {
      await old.app.goto('./#make-series');
      await until(old.app, by('series-add-ready'));
      for (const course of ['square', 'closed-line']) await choose(old.app, 'series-add-ready', course);
      await until(old.app, by('series-row-1'));
      await old.app.fill(by('series-title'), 'Week 3');
      await old.app.click(by('series-make-link'));
      await until(old.app, by('series-link'));
      const link = await old.app.evaluate(() => document.querySelector<HTMLInputElement>('[data-testid=series-link]')!.value); // prettier-ignore
      await old.app.goto('./logo.svg');
      await old.app.goto(`./#${link.split('#')[1] ?? ''}`);
      await until(old.app, by('series-task-1'));
    });

    test('is the simulator of another editor', async () => {
      const host = await microbitHost();
      try {
        await old.app.goto(`${host.url}?simulator=${encodeURIComponent(`${appAddress()}simulator.html`)}`);
        const serial = (): Promise<string> =>
          old.app.evaluate(() => (window as never as { simulators?: SimulatorOfHost[] }).simulators?.[0]?.serial ?? '');
        await expect.poll(() => old.app.evaluate(() => (window as never as { simulators?: SimulatorOfHost[] }).simulators?.[0]?.status)).toBe('connected'); // prettier-ignore
        await old.app.evaluate(() => {
          const [simulator] = (window as never as { simulators: { files: object; flash(): void }[] }).simulators;
          simulator!.files = { 'main.py': 'print("old but", 40 + 2)\n' };
          simulator!.flash();
        });
        await expect.poll(serial).toContain('old but 42');
      } finally {
        host.close();
      }
    });
  });
}
