import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { CREEP, linkTo, openClass, paste, RIGHT, select } from './class-page';
import { by, gone, until } from './parts';

/** A line of an e-mail: who, and the link of a program. */
const line = (name: string, text: string): string => `${name}: ${linkTo(text)}`;

test(
  'a wall fills with what is pasted while it is up, names only who has passed, and lets all drive once more',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    await openClass(app, 'closed-line');
    await app.click(by('class-open-wall'));
    await until(app, by('class-wall'));
    await paste(app, 'Guten Tag');
    await expect.poll(() => app.text(by('class-wall'))).toContain('In diesem Text ist kein Link zu einem Programm.');
    await paste(app, [line('Ada', RIGHT), line('Ben', CREEP)].join('\n'));
    await expect.poll(() => app.text(by('wall-sum')), { timeout: 60_000 }).toBe('1 von 2 bestanden');
    await paste(app, line('Cem', RIGHT));
    await expect.poll(() => app.text(by('wall-sum')), { timeout: 60_000 }).toBe('2 von 3 bestanden');
    const cards = async (): Promise<string> => (await app.text(by('wall-cards'))).replace(/\s+/g, ' ');
    await expect.poll(cards).toMatch(/^Ada bestanden 19\.5 s Cem bestanden 19\.5 s Nr\. [123] noch unterwegs$/);
    await select(app, 'wall-naming', 'all');
    await expect.poll(cards).toMatch(/^Ada .* Ben noch unterwegs Cem /);
    await select(app, 'wall-naming', 'none');
    await expect.poll(cards).not.toMatch(/Ada|Ben|Cem/);
    await select(app, 'wall-naming', 'passed');
    await app.click(by('wall-as-ways'));
    await expect.poll(() => app.text(by('wall-arrived'))).toMatch(/Ada\s*19\.5 s\s*Cem\s*19\.5 s/);
    const inked = (): Promise<number> =>
      app.evaluate(() => {
        const canvas = document.querySelector<HTMLCanvasElement>('canvas[data-testid=wall-ways]')!;
        const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
        return data.filter((value, place) => place % 4 === 3 && value > 0).length;
      });
    const whole = await inked();
    await select(app, 'wall-speed', '0.5');
    await app.click(by('wall-play'));
    await expect.poll(inked).toBeLessThan(whole / 2);
    const early = await inked();
    await expect.poll(inked, { timeout: 20_000 }).toBeGreaterThan(early);
    await app.press('Escape');
    await gone(app, by('class-wall'));
    expect(await app.text(by('class-table'))).toContain('Ben');
  },
);
