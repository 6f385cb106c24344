import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import type { HostPage } from './hosts';
import { parcoursHost } from './hosts/parcours/host-page';

const opened: HostPage[] = [];
test.afterEach(() => {
  for (const host of opened.splice(0)) host.close();
});

/** Opens a host page whose frame shows these parts, and waits until its client is there. */
async function openHost(app: App, show: string): Promise<void> {
  const host = await parcoursHost(`?lang=en&dialect=none&show=${show}`);
  opened.push(host);
  await app.goto(host.url);
  await app.evaluate(async () => {
    while (!('connect' in globalThis)) await new Promise((resolve) => setTimeout(resolve, 50));
  });
}

const MAIN = `from mbrobot import *
from turning import turn
count = 0
forward()
while count < 200:
    turn(count)
    count += 1
`;
const TURNING = `from mbrobot import *
def turn(n):
    half = n / 2
    delay(20)
    return half
`;
const FILES = [
  { name: 'main.py', text: MAIN },
  { name: 'turning.py', text: TURNING },
];

/** With the arena, and without it, where the page has no time line. */
for (const show of ['code,board,arena', 'console'])
  test(
    `a host stops a program at a line, steps, reads its variables and goes back in time (${show})`,
    IN_ONE_ENGINE,
    async ({ app }) => {
      await openHost(app, show);
      const heard = await app.evaluate(async (files) => {
        const parcours = await connect(document.querySelector<HTMLIFrameElement>('#parcours')!);
        const held: { line: number; file: string; atMs: number }[] = [];
        parcours.on('held', (stop) => void held.push(stop));
        const looking: (number | null)[] = [];
        parcours.on('looking', ({ atMs }) => void looking.push(atMs));
        const points: number[][] = [];
        parcours.on('break-points-changed', (changed) => void points.push(changed.points.map(({ line }) => line)));
        const stops = async (count: number): Promise<void> => {
          while (held.length < count) await new Promise((resolve) => setTimeout(resolve, 20));
        };
        const refusal = (promise: Promise<unknown>): Promise<string> =>
          promise.then(
            () => 'done',
            (error: unknown) => (error as Error).message,
          );
        await parcours.setRobot({ robot: 'maqueen-lite' });
        await parcours.setSpeed('max');
        await parcours.setFiles(files);
        const refused = [
          await refusal(parcours.getPosition()),
          await refusal(parcours.stepLine('over')),
          await refusal(parcours.lookAt(0)),
          await refusal(parcours.setBreakPoints([{ file: 'other.py', line: 1 }])),
          await refusal(parcours.setBreakPoints([{ file: 'main.py', line: 99 }])),
          await refusal(parcours.setBreakPoints([{ file: 'main.py', line: 0 }])),
          await refusal(parcours.stepLine('sideways' as never)),
          await refusal(parcours.goOn()),
        ];
        await parcours.setBreakPoints([{ file: 'turning.py', line: 3 }]);
        await parcours.run();
        await stops(1);
        const first = await parcours.getPosition();
        await parcours.stepLine('over');
        await stops(2);
        await parcours.stepLine('out');
        await stops(3);
        await parcours.setBreakPoints([]);
        await parcours.runTo({ file: 'main.py', line: 7 });
        await stops(4);
        await parcours.stepLine('into');
        await stops(5);
        const now = await parcours.getPosition();
        await parcours.stepLine('back');
        const before = await parcours.getPosition();
        const looks = (await parcours.getState()).looking;
        await parcours.lookNow();
        await parcours.resume();
        while ((await parcours.getState()).atMs < 3000) await new Promise((resolve) => setTimeout(resolve, 50));
        await parcours.lookAt(1000);
        const past = await parcours.getPosition();
        const shown = (await parcours.getState()).snapshot;
        const late = await refusal(parcours.lookAt(9_999_999));
        await parcours.goOn({ paused: true });
        const there = await parcours.getState();
        const same = await parcours.getPosition();
        await parcours.setBreakPoints([{ file: 'main.py', line: 6 }]);
        await parcours.resume();
        const count = held.length + 1;
        await stops(count);
        const again = await parcours.getPosition();
        await parcours.setBreakPoints([]);
        await parcours.stop();
        parcours.close();
        return { refused, held, looking, points, first, now, before, looks, past, shown, late, there, same, again };
      }, FILES);
      expect(heard.refused).toEqual([
        'This needs a run; it is ready.',
        'This needs a run that is paused; it is ready.',
        'This needs a run that has been.',
        'points[0]: there is no file "other.py"; the program has main.py, turning.py.',
        'points[0]: main.py has 8 lines, no line 99.',
        expect.stringContaining('points.0.line'),
        expect.stringContaining('step'),
        'This needs a moment of the past: look-at chooses one.',
      ]);
      expect(heard.held.slice(0, 6).map(({ file, line }) => [file, line])).toEqual([
        ['turning.py', 3],
        ['turning.py', 4],
        ['main.py', 6],
        ['main.py', 7],
        ['main.py', 5],
        ['main.py', 7],
      ]);
      expect(heard.first).toMatchObject({
        file: 'turning.py',
        line: 3,
        stack: [
          { function: 'turn', file: 'turning.py', line: 3, locals: { n: { type: 'int', text: '0' } } },
          { function: '<module>', file: 'main.py', line: 6, locals: {} },
        ],
      });
      expect(heard.now).toMatchObject({ line: 5, globals: { count: { type: 'int', text: '1' } } });
      expect(heard.before).toMatchObject({ line: 7, globals: { count: { type: 'int', text: '0' } } });
      expect(heard.looks).toBe(true);
      expect(heard.past.atMs).toBeGreaterThan(990);
      expect(heard.past.atMs).toBeLessThanOrEqual(1020);
      expect(heard.shown?.atMs).toBe(1000);
      expect(heard.late).toMatch(/^The run has come to \d+(\.\d+)? ms; there is no moment at 9999999 ms\.$/);
      expect(heard.there).toMatchObject({ phase: 'paused', looking: false });
      expect(heard.there.atMs).toBeGreaterThanOrEqual(1000);
      expect(heard.there.atMs).toBeLessThan(1030);
      expect(heard.there.snapshot?.robot?.xMm).toBeCloseTo(heard.shown?.robot?.xMm ?? NaN, -1);
      expect(heard.same.stack[0]?.function).toBe('turn');
      expect(Number(heard.same.stack[0]?.locals['n']?.text)).toBeGreaterThan(10);
      expect(heard.again).toMatchObject({ file: 'main.py', line: 6 });
      expect(heard.looking).toContain(1000);
      expect(heard.looking).toContain(null);
      expect(heard.points).toEqual([[3], [], [6], []]);
    },
  );
