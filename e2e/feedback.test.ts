import { expect, test } from './app';
import { CREEP, linkTo, openClass, paste } from './class-page';
import { IN_ONE_ENGINE } from './engines';
import { isEnabled, isThere, programIn } from './page';
import { by, gone, until } from './parts';

test(
  'a feedback opens the own program at the moment at which it went wrong, with the note as text, and goes on from there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(60_000);
    const note = 'Fast! <b>Langsamer</b> ist sicherer.';
    await openClass(app, 'closed-line');
    await paste(app, `Ben: ${linkTo(CREEP)}`);
    await until(app, by('class-table'));
    await expect.poll(() => isThere(app, 'progress'), { timeout: 30_000 }).toBe(false);
    await app.click(`${by('class-table')} .name`);
    await app.fill(by('class-note'), 'x'.repeat(501));
    await until(app, by('note-too-long'));
    await app.fill(by('class-note'), note);
    await gone(app, by('note-too-long'));
    await app.click(by('class-feedback'));
    await until(app, by('feedback-link'));
    const link = await app.evaluate(
      () => document.querySelector<HTMLInputElement>('[data-testid=feedback-link]')!.value,
    );
    await app.goto(`./${link.slice(link.indexOf('#'))}`);
    await until(app, by('task-feedback'));
    expect(await app.text(by('task-feedback'))).toContain(note);
    await expect.poll(() => app.text(by('feedback-moment')), { timeout: 20_000 }).toMatch(/^Hier ging es schief\s*Bei \d+\.\d s, in Zeile \d$/); // prettier-ignore
    expect(await programIn(app)).toContain('setSpeed(20)');
    expect(await app.text(by('share'))).toContain('Nochmals abgeben');
    await until(app, by('go-on'));
    await app.click(by('go-on'));
    await gone(app, by('go-on'));
    await expect.poll(() => isEnabled(app, 'stop')).toBe(true);
    // The note stays with the work.
    await until(app, by('task-feedback'));
  },
);
