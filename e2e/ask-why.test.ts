import { expect, test, type App } from './app';
import { inWindow, robotAt } from './arena';
import { violationsOn } from './axe';
import { IN_ONE_ENGINE } from './engines';
import { on, openApp, pasteProgram } from './page';
import { by, gone, until } from './parts';

const PROGRAM = `from mbrobot import *
from microbit import display, Image
setSpeed(30)
def corner():
    left()
    delay(300)
forward()
display.show(Image.HAPPY)
setLED(1)
delay(800)
print("corner")
corner()
forward()
delay(500)
stop()
print("ready")
delay(60000)
`;
/** The size of the course that a first visit shows, in mm. */
const SIZE = [700, 400] as const;

const card = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="why"]')?.textContent ?? '');
const console = (app: App): Promise<string> =>
  app.evaluate(() => document.querySelector('[data-testid="console"]')?.textContent ?? '');
/** Simulated time on the time line, in ms. */
const at = async (app: App): Promise<number> =>
  Number(await app.evaluate(() => document.querySelector('[data-testid="time-rail"]')?.getAttribute('aria-valuenow')));

/** The program has been run, and somebody looks back. */
async function lookBackAt(app: App): Promise<void> {
  await openApp(app);
  await pasteProgram(app, PROGRAM);
  await app.click(on('run'));
  await expect.poll(() => console(app)).toContain('ready');
  await app.click(by('mode-lookBack'));
  await until(app, by('time-rail'));
}

/** A place of the robot that is shown, x ahead of its axle and y to its left, in the window. */
async function ofRobot(app: App, ahead: number, left: number) {
  const { xMm, yMm, headingDeg } = await robotAt(app);
  const [cos, sin] = [Math.cos((headingDeg * Math.PI) / 180), Math.sin((headingDeg * Math.PI) / 180)];
  return inWindow(app, SIZE, [[xMm + ahead * cos - left * sin, yMm + ahead * sin + left * cos]]);
}

test(
  'a tap on the wheel of a robot that stands names the line that stopped it, and leads there',
  IN_ONE_ENGINE,
  async ({ app }) => {
    await lookBackAt(app);
    await app.draw(await ofRobot(app, 0, 36));
    await expect.poll(() => card(app)).toMatch(/(Stands since|Steht seit) 1\.\d s.*(Line|Zeile) 15.*stop\(\)/);
    await app.click(by('why-go'));
    await gone(app, by('why'));
    await expect.poll(() => app.text(by('step-at'))).toMatch(/ 15$/);
    expect(await at(app)).toBeGreaterThan(1500);
    expect(await at(app)).toBeLessThan(2000);
    // There it drives still: the line before has made it so.
    await app.draw(await ofRobot(app, 0, 36));
    await expect.poll(() => card(app)).toMatch(/(Forwards since|Vorwärts seit) 1\.\d s.*(Line|Zeile) 13.*forward\(\)/);
  },
);

test('a right click asks while the program runs: then it is looked back', IN_ONE_ENGINE, async ({ app }) => {
  await openApp(app);
  await pasteProgram(app, PROGRAM);
  await app.click(on('run'));
  await expect.poll(() => console(app)).toContain('ready');
  await app.draw(await ofRobot(app, 0, 36), 'right');
  await until(app, by('time-rail'));
  await expect.poll(() => card(app)).toMatch(/(Line|Zeile) 15.*stop\(\)/);
  await app.press('Escape');
  await gone(app, by('why'));
  await until(app, by('time-rail'));
});

test('the trail, a line in the console and the list of all name their lines', IN_ONE_ENGINE, async ({ app }) => {
  await lookBackAt(app);
  await app.click(by('console-fold'));
  await app.draw(await inWindow(app, SIZE, [[190, 200]])); // soon after the start
  await expect
    .poll(() => card(app))
    .toMatch(/(Drives like this since|Fährt so seit) 0\.\d s.*(Line|Zeile) 7.*forward\(\)/);
  await app.click(by('why-line'));
  await expect.poll(() => card(app)).toMatch(/(Written at|Geschrieben bei) 0\.8 s.*(Line|Zeile) 11.*print\("corner"\)/);
  await app.click(by('why-all'));
  await expect
    .poll(() => card(app))
    .toMatch(
      / 0\.8 s.*(Wheels|Räder).*(Line|Zeile) 7.*(Lights|Lichter).*(Line|Zeile) 9.*(Display|Anzeige).*(Line|Zeile) 8/,
    );
  await app.click(by('why-close'));
  await app.draw(await ofRobot(app, 20, 0)); // its display
  await expect.poll(() => card(app)).toMatch(/(Line|Zeile) 8.*display\.show/);
  await app.click(by('why-close'));
  await app.click(by('why-open'));
  await expect
    .poll(() => card(app))
    .toMatch(
      /(Wheels|Räder).*(Line|Zeile) 15.*(Lights|Lichter).*(Line|Zeile) 9.*(Display|Anzeige).*(Line|Zeile) 8.*(Console|Konsole).*(Line|Zeile) 16/,
    );
  expect(await violationsOn(app)).toEqual([]);
});

test('by keyboard alone all is told and reached; the list follows the time line', IN_ONE_ENGINE, async ({ app }) => {
  await lookBackAt(app);
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="why-open"]')?.focus());
  await app.press('Enter');
  await expect.poll(() => card(app)).toContain('stop()');
  await app.press('Tab'); // close
  await app.press('Tab'); // the wheels
  await app.press('Enter');
  await gone(app, by('why'));
  await expect.poll(() => app.text(by('step-at'))).toMatch(/ 15$/);
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="why-open"]')?.focus());
  await app.press('Enter');
  await until(app, by('why-go'));
  await app.evaluate(() => document.querySelector<HTMLElement>('[data-testid="time-rail"]')?.focus());
  await app.press('Home');
  await expect.poll(() => card(app)).toContain('No line has controlled the motor yet.');
});
