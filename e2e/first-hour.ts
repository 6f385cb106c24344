import type { Language } from '../src/core/languages';
import { robotAt } from './arena';
import { expect, type App } from './app';
import { distance } from './course';
import { attribute, consoleIn, isEnabled, isThere, on, programIn } from './page';
import { by, gone, until } from './parts';
import { beginWith, openMenu } from './pupil';

/** A pupil at a tablet on the first day. */
export interface Beginner {
  readonly app: App;
  readonly language: Language;
  /** Puts the keyboard of the tablet to use: what it writes, and its return and delete keys. */
  readonly keyboard: { write(text: string): Promise<void>; strike(key: 'Enter' | 'Backspace'): Promise<void> };
  /** Looks at the page: everything on it is in the pupil's language. The name is that of the picture of it. */
  readonly look: (name: string) => Promise<void>;
}

/** The words of the first program in the pupil's language: its comment, and its output. */
const PROGRAM_WORDS: Readonly<Record<Language, readonly [comment: string, said: string]>> = {
  de: ['Herz, bis ich A drücke', 'Hallo, ich bin da!'],
  fr: ['Un cœur, jusqu’à ce que j’appuie sur A', 'Bonjour, me voilà !'],
  it: ['Un cuore, finché premo A', 'Ciao, eccomi!'],
  en: ['A heart, until I press A', 'Hello, here I am!'],
};

/** Lights of the pictures, as the board says them. */
const HEART = '0 9 0 9 0, 9 9 9 9 9, 9 9 9 9 9, 0 9 9 9 0, 0 0 9 0 0';
const HAPPY = '0 0 0 0 0, 0 9 0 9 0, 0 0 0 0 0, 9 0 0 0 9, 0 9 9 9 0';

const stepIs = (app: App, step: string): Promise<void> =>
  expect.poll(() => attribute(app, by('tour'), 'data-step')).toBe(step);

/** From the greeting through the tour to its end; what it asks for is done at the real controls. */
export async function takeTour({ app, look }: Beginner): Promise<void> {
  await app.goto('./');
  await until(app, by('welcome'));
  await look('greeting');
  await app.click(by('menu'));
  await until(app, by('menu-tour'));
  await app.click(by('menu-tour'));
  await stepIs(app, 'code');
  await look('tour-code');
  await app.click(by('tour-next'));
  await stepIs(app, 'run');
  await look('tour-run');
  await app.click(on('run'));
  await stepIs(app, 'arena');
  await look('tour');
  for (const step of ['console', 'stop']) {
    await app.click(by('tour-next'));
    await stepIs(app, step);
    await look(`tour-${step}`);
  }
  await app.click(on('stop'));
  for (const step of ['tools', 'course', 'help']) {
    await stepIs(app, step);
    await look(`tour-${step}`);
    await app.click(by('tour-next'));
  }
  await gone(app, by('tour'));
}

/** With the microcomputer alone: a first program is written and run; the display shows it, and button A changes it. */
export async function writeFirstProgram(beginner: Beginner): Promise<void> {
  const { app, language, look } = beginner;
  await openMenu(app);
  await look('menu');
  await app.draw([{ x: 4, y: 600 }]); // a tap beside it
  await gone(app, '[role=menu]');
  await beginWith(app, 'board');
  await gone(app, on('arena'));
  await expect.poll(() => programIn(app)).toContain('from microbit import *'); // an example to look at first
  const [comment, said] = PROGRAM_WORDS[language];
  await write(beginner, [
    `# ${comment}`,
    'from microbit import *',
    'display.show(Image.HEART)',
    'while not button_a.was_pressed():',
    '    sleep(50)',
    'display.show(Image.HAPPY)',
    `print("${said}")`,
  ]);
  await app.click(on('run'));
  await expect.poll(() => display(app)).toContain(HEART);
  await look('board');
  await app.click('#ButtonA');
  await expect.poll(() => display(app)).toContain(HAPPY);
  await expect.poll(() => consoleIn(app)).toContain(said);
  await look('board-pressed');
  if (await isEnabled(app, 'stop')) await app.click(on('stop'));
}

const display = (app: App): Promise<string | null> =>
  app.evaluate(
    (css) => document.querySelector(css)?.closest('[role=img]')?.getAttribute('aria-label') ?? null,
    `${by('board')} #LEDsOn`,
  );

/** Replaces the program: the text is chosen by the tablet's own menu, and each line comes as its keyboard gives it. */
async function write({ app, keyboard }: Beginner, lines: readonly string[]): Promise<void> {
  await app.click(on('editor'));
  await app.press('Control', 'a');
  await keyboard.strike('Backspace');
  let indent = '';
  for (const [place, line] of lines.entries()) {
    if (place > 0) await keyboard.strike('Enter'); // the editor indents by itself …
    const own = /^ */.exec(line)?.[0] ?? '';
    if (indent.length > own.length) await keyboard.strike('Backspace'); // … and one press takes an indent back
    await keyboard.write(line.trimStart());
    indent = line.endsWith(':') ? `${own}    ` : own;
  }
  await expect.poll(() => programIn(app)).toBe(lines.join('\n'));
}

/** With the robot: an example out of the list of courses is opened, and drives. */
export async function driveFirst({ app, language, look }: Beginner): Promise<void> {
  await beginWith(app, 'robot');
  await until(app, on('arena'));
  await app.click(by('course'));
  await until(app, by('samples'));
  await app.click(by('samples'));
  await until(app, '[data-testid^="examples-"]');
  await app.click('[data-testid^="examples-"]');
  await until(app, '[data-testid^="example-"]');
  await look('examples');
  await app.click('[data-testid^="example-"]');
  await gone(app, '[role=menu]');
  await expect.poll(() => programIn(app)).not.toContain(PROGRAM_WORDS[language][0]);
  await look('example');
  const start = await robotAt(app);
  const before = await tracebacks(app);
  await app.click(on('run'));
  await expect.poll(async () => distance(await robotAt(app), [start.xMm, start.yMm])).toBeGreaterThan(100);
  await look('drive');
  expect(await tracebacks(app)).toBe(before);
  await app.click(on('stop'));
}

/** How many errors the console has had; one is the interrupt of a program that was stopped in the midst of a command. */
const tracebacks = async (app: App): Promise<number> => (await consoleIn(app)).split('Traceback').length;

/** The last of the speeds, which is as fast as it goes. */
const FULL_SPEED = '[role=menuitemradio]:last-child';

/** A ready course: its task is read in the gallery, its solution is run at full speed, and the verdict says that it is passed. */
export async function passFirstCourse(
  { app, look }: Beginner,
  words: { readonly task: string; readonly passed: string },
): Promise<void> {
  await app.click(by('course'));
  await until(app, by('all-courses'));
  await app.click(by('all-courses'));
  await until(app, by('course-square'));
  await look('gallery');
  await app.click(`${by('course-square')} h3 a`);
  await until(app, by('show-solution'));
  expect(await app.text('.gallery .sheet')).toContain(words.task);
  await look('task');
  await app.click(by('show-solution'));
  await app.click(by('open-solved'));
  await gone(app, '.gallery');
  if (await isThere(app, '.page-overlay .ctl--run')) await app.click('.page-overlay .ctl--run');
  await until(app, by('verdict'));
  await app.click(by('speed'));
  await until(app, FULL_SPEED);
  await look('speed');
  await app.click(FULL_SPEED);
  await gone(app, '[role=menu]');
  await app.click(on('run'));
  await expect.poll(() => app.text(by('verdict')), { timeout: 60_000 }).toContain(words.passed);
  await look('course');
}

/** The link to it all, out of the dialog. */
export async function shareIt({ app, look }: Beginner): Promise<string> {
  await app.click(by('share'));
  await until(app, by('share-link'));
  await look('share');
  const link = await app.evaluate(
    (css) => document.querySelector<HTMLInputElement>(css)?.value ?? '',
    by('share-link'),
  );
  await app.click(by('share-close'));
  await gone(app, by('share-dialog'));
  return link;
}
