import { expect, test, type App } from './app';
import { violationsIn, violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { appAddress, hostPage, isInFrame, type HostPage } from './hosts';
import { consoleIn, on, openApp, pasteProgram } from './page';
import { by, until } from './parts';
import { build, courseMenu, fromMenu, openMenu } from './pupil';

/** It fills the radio panel, the data log and the console, and ends with an error. */
const PROGRAM = ['import radio, log', 'radio.on()', 'radio.send("hello")', 'log.add(n=1)', 'print(nn)'];

/** Runs the program on a board; afterwards the error is explained in the console, and the REPL waits. */
async function runOn(app: App, module: string): Promise<void> {
  await pasteProgram(app, [`from ${module} import *`, ...PROGRAM].join('\n'));
  await app.click(on('run'));
  await until(app, '[role=log] .card');
  await app.click(by('error-raw'));
  await app.click(by('error-repl')); // the board shows its error by scrolling for half a minute; this ends it
  await expect.poll(() => consoleIn(app)).toContain('>>>');
}

for (const { theme, language } of [
  { theme: 'light', language: 'de' },
  { theme: 'dark', language: 'fr' },
] as const) {
  test(
    `axe finds nothing that shuts people out of the page and its menus, ${language}, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { theme, language });
      expect(await violationsOn(app), 'as it opens').toEqual([]);

      await pasteProgram(app, 'from microbit import *\n');
      await app.type('display.');
      await until(app, '.cm-completionInfo');
      expect(await violationsOn(app), 'with the list of suggestions').toEqual([]);
      await app.press('Escape');

      await app.click('[data-testid=device]');
      await until(app, '[data-testid=board-calliope-mini-3]');
      expect(await violationsOn(app), 'with the menu of devices').toEqual([]);
    },
  );
}

for (const { theme, language, module, drawing } of [
  { theme: 'light', language: 'it', module: 'microbit', drawing: 'svg.microbit' },
  { theme: 'dark', language: 'en', module: 'calliopemini', drawing: 'svg.calliope' },
] as const) {
  test(
    `axe finds nothing that shuts people out after a run of ${module}, with every panel, ${language}, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { theme, language });
      await runOn(app, module);
      await until(app, drawing);
      expect(await violationsOn(app), 'with an error and the REPL').toEqual([]);
      for (const { panel, sign } of [
        { panel: 'sensors', sign: '.panel-open details' },
        { panel: 'radio', sign: '.panel-open li' },
        { panel: 'log', sign: '.panel-open tr.data' },
      ]) {
        await app.click(`[data-testid=panel-${panel}]`);
        await until(app, sign);
        await app.evaluate(() => {
          document.querySelectorAll('details').forEach((fold) => fold.setAttribute('open', ''));
        });
        expect(await violationsOn(app), `with the panel ${panel}`).toEqual([]);
      }
    },
  );
}

let host: HostPage | null = null;

test.afterEach(() => {
  host?.close();
  host = null;
});

/** Opens a part of the app in a frame of another site, and waits for something in it. */
async function openFramed(app: App, path: string, sign: string): Promise<void> {
  host = await hostPage(
    `<iframe src="${appAddress()}${path}" title="Simulator" style="display:block;border:0;width:590px;height:410px"></iframe>`,
  );
  await app.goto(host.url);
  await expect.poll(() => isInFrame(app, sign)).toBe(true);
}

const fromMainMenu = (app: App, entry: string, dialog: string): Promise<void> =>
  fromMenu(app, by('menu'), by(entry), () => app.evaluate((css) => document.querySelector(css) !== null, by(dialog)));

/** Closes what lies over the page; the keyboard's focus is in it. */
async function leave(app: App, what: string): Promise<void> {
  await expect(async () => {
    await app.press('Escape');
    await expect.poll(() => app.evaluate((css) => document.querySelector(css) === null, what), { timeout: 2000 }).toBe(true); // prettier-ignore
  }).toPass();
}

/** Opens something; what leads away from the page comes last in a list. */
const SCREENS = {
  greeting: (app: App) => until(app, by('welcome')),
  tour: async (app: App) => {
    await app.click(by('menu'));
    await until(app, by('menu-tour'));
    await app.click(by('menu-tour'));
    await until(app, `${by('tour')} ${by('tour-next')}`);
  },
  'main menu': (app: App) => openMenu(app),
  'list of the main menu': (app: App) => openMenu(app, 'save'),
  'list of courses': async (app: App) => {
    await app.click('header .course');
    await until(app, by('all-courses'));
  },
  'link to share': async (app: App) => {
    await app.click(by('share'));
    await until(app, by('share-link'));
  },
  'link to open': (app: App) => fromMainMenu(app, 'menu-open', 'open-dialog'),
  'real device': (app: App) => fromMainMenu(app, 'menu-real-device', 'way-firmware'),
  'list of objects': async (app: App) => {
    await courseMenu(app, 'list');
    await until(app, `${by('panel-list')} .item`);
  },
  print: async (app: App) => {
    await build(app);
    await fromMenu(app, by('course-more'), by('editor-print'), () =>
      app.evaluate((css) => document.querySelector(css) !== null, by('print-dialog')),
    );
    await until(app, by('picture-preview'));
  },
  worksheet: async (app: App) => {
    await SCREENS.print(app);
    await app.click(by('print-sheet'));
    await until(app, by('sheet-page'));
  },
  'all courses': async (app: App) => {
    await app.goto('./#courses');
    await until(app, by('course-slalom'));
  },
  'a course': async (app: App) => {
    await app.goto('./#courses/slalom');
    await until(app, by('open-slalom'));
  },
  teachers: async (app: App) => {
    await app.goto('./#teachers');
    await until(app, by('menu-task'));
  },
  missions: async (app: App) => {
    await app.goto('./#missions');
    await until(app, by('mission-forward'));
  },
  'all robots': async (app: App) => {
    await app.goto('./#robots');
    await until(app, by('card-maqueen-lite'));
  },
  'a robot': async (app: App) => {
    await app.goto('./#robots/maqueen-lite');
    await until(app, '.gallery .sheet');
  },
} as const;

type Screen = keyof typeof SCREENS;

/** The elements that Escape closes, so that the next screen finds the page as it was. */
const CLOSES: Readonly<Partial<Record<Screen, string>>> = {
  tour: by('tour'),
  'main menu': '[role=menu]',
  'list of the main menu': '[role=menu]',
  'list of courses': '[role=menu]',
  'link to share': by('share-dialog'),
  'link to open': by('open-dialog'),
  'real device': by('real-device-dialog'),
  'list of objects': by('panel-list'),
  print: by('print-dialog'),
};

/** Each screen in two languages; all four over all screens. The help is looked at in `first-steps`, with all of it open. */
const LOOKS: readonly {
  readonly language: 'de' | 'fr' | 'it' | 'en';
  readonly theme: 'light' | 'dark';
  readonly screens: readonly Screen[];
}[] = [
  {
    language: 'de',
    theme: 'dark',
    screens: [
      'greeting',
      'tour',
      'main menu',
      'real device',
      'link to share',
      'print',
      'worksheet',
      'all courses',
      'a course',
      'missions',
    ],
  },
  {
    language: 'fr',
    theme: 'light',
    screens: ['list of courses', 'real device', 'link to share', 'worksheet', 'missions', 'all robots', 'a robot'],
  },
  {
    language: 'it',
    theme: 'light',
    screens: ['greeting', 'tour', 'main menu', 'link to open', 'list of objects', 'all courses', 'a course'],
  },
  {
    language: 'en',
    theme: 'dark',
    screens: ['list of courses', 'link to open', 'print', 'list of objects', 'all robots', 'a robot'],
  },
];

for (const { language, theme, screens } of LOOKS) {
  test(
    `axe finds nothing that shuts people out of what opens over the page, ${language}, ${theme}`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openApp(app, { language, theme, welcomed: !screens.includes('greeting') });
      for (const screen of screens) {
        await SCREENS[screen](app);
        expect(await violationsOn(app), screen).toEqual([]);
        const closes = CLOSES[screen];
        if (closes !== undefined) await leave(app, closes);
      }
    },
  );
}

for (const { path, sign } of [
  { path: 'simulator.html?lang=fr', sign: '.play-button' },
  { path: 'simulator.html?lang=it&dialect=none&show=board,arena&theme=dark', sign: '[role=application]' },
  { path: '?lang=de&show=code,console', sign: '.code-editor .cm-content' },
  { path: '?lang=en&show=bar,arena&theme=dark', sign: '[role=application]' },
])
  test(`axe finds nothing that shuts people out of a framed part, ${path}`, IN_ONE_ENGINE, async ({ app }) => {
    await openFramed(app, path, sign);
    expect(await violationsIn(app, 'iframe')).toEqual([]);
  });
