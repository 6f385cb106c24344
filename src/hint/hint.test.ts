import { describe, expect, it } from 'vitest';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { checked, firmware, readyScene, readySolution, sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { LANGUAGES } from '#core/languages';
import { withChange } from './changes/change';
import { hintFor, type Hint } from './hint';
import type { HintLevel } from './level';
import { hintJson } from './hint-json';
import { hintText } from './say';
import { corpus, faulty } from './testing/corpus';
import type { ClassTask } from '#check/task/task';

const hinted = (task: ClassTask, text: string, budget = 100): Promise<Hint | null> =>
  hintFor(task, handInOfFiles([{ name: 'main.py', text }]), { firmware: firmware(), budget });

/** A target one second ahead, and a wall behind it. */
const ahead = taskWith(sceneWith([targetAt(420, 450)], { task: { ...sceneWith([]).task, seconds: 8 } }));
const DRIVES = 'from mbrobot import *\nsetSpeed(50)\nforward()\ndelay(1100)\nstop()\n';
/** Small enough for a unit test; `npm run bench -- --hints` has all of them. */
const some = corpus.filter(({ course, kind }) => course === 'push' && ['polarity', 'comparison'].includes(kind));

describe('a hint', () => {
  it('is none to a program that passes', async () => expect(await hinted(ahead, DRIVES)).toBeNull());

  it('says that the robot never moved', async () => {
    const hint = await hinted(ahead, 'from mbrobot import *\nstop()\n', 0);
    expect(hint).toMatchObject({ happened: { fact: 'unmoved' }, change: null, tried: 0 });
  });

  it('says where the program ended before the target, and finds that a number is too small', async () => {
    const hint = await hinted(ahead, DRIVES.replace('1100', '400'));
    expect(hint?.happened).toMatchObject({ fact: 'ended' });
    expect(hint?.change).toMatchObject({ kind: 'number', line: 4, direction: 'more', before: ['delay(400)'] });
  });

  it('says when the program stopped with an error, but names its line only from level 2', async () => {
    const hint = await hinted(ahead, DRIVES.replace('forward()', 'foward()'));
    expect(hint?.happened).toMatchObject({ fact: 'error', type: 'NameError', line: 3 });
    expect(hint?.change).toMatchObject({ kind: 'name', line: 3, after: ['forward()'] });
    expect(hintText(hint!, 1, 'en')).not.toMatch(/line|forward/);
  });

  it('tries nothing of a program that stays broken, and names the line of the error', async () => {
    const hint = await hinted(ahead, DRIVES.replace('forward()', 'forward('));
    expect(hint).toMatchObject({ change: null, tried: 0 });
    expect(hintText(hint!, 2, 'en')).toMatch(/^Your program does not run.* Look at line \d\. No change/);
    expect(JSON.parse(hintJson(hint, 1, 'en'))).toMatchObject({ hint: { line: null } });
  });

  it('takes one try for a library that is spelt in another way', async () => {
    const hint = await hinted(ahead, DRIVES.replace('mbrobot', 'mbrobo'));
    expect(hint).toMatchObject({ tried: 1, change: { kind: 'name', after: ['from mbrobot import *'] } });
  });

  it.each([
    [{ id: 'c', type: 'radio', text: '5' }, 'import radio\nradio.on()\nprint(radio.send(str(4)))\n'],
    [{ id: 'c', type: 'log', rows: 5, column: 'n' }, 'import log\nfor n in range(3): log.add(n=n)\n'],
    [{ id: 'c', type: 'log', rows: 1, column: 'n5' }, 'import log\nlog.add({"n" + str(4): 1})\n'],
    [{ id: 'c', type: 'console', text: '5' }, 'print(4)\n'],
  ] as const)('finds a number that shows only in what $type looks at', async (look, program) => {
    const hint = await hinted(taskWith(sceneWith([]), { checks: [look] }), program);
    expect(hint?.happened).toMatchObject({ fact: 'reason', reason: { code: look.type } });
    expect(hint?.change).toMatchObject({ kind: 'number', direction: 'more' });
  });

  it('says in which column the data log lacks rows', async () => {
    const look = { id: 'c', type: 'log', rows: 2, column: 'n' } as const;
    const hint = await hinted(taskWith(sceneWith([]), { checks: [look] }), 'import log\nlog.add(m=1)\n', 0);
    expect(hintText(hint!, 1, 'en')).toMatch(/fewer than 2 rows\. Only rows with a value under “n” count\./);
  });

  it('tries nothing in lines that the program never comes to', async () => {
    const rest = 'forward()\ndelay(1100)\nstop()\n'.repeat(20);
    const hint = await hinted(ahead, `from mbrobot import *\nx = 1 / zero\n${rest}`);
    expect(hint?.tried).toBeLessThan(40);
  });

  it('begins to try without reading the program for each change', async () => {
    const long = 'forward()\nleft()\nsetLED(0, 1)\ndelay(20)\nstop()\n'.repeat(30);
    const start = process.cpuUsage();
    await hinted(ahead, `from mbrobot import *\nstop()\nwhile button_a.is_pressed():\n    stop()\n${long}`, 1);
    expect(process.cpuUsage(start).user).toBeLessThan(5_000_000);
  });

  it.each(some)('holds: $course, $kind, $wrong', async (fault) => {
    const task = taskWith(readyScene(fault.course));
    const { text } = faulty(readySolution(fault.course), fault);
    const hint = await hinted(task, text);
    expect(hint?.change).toMatchObject({ kind: fault.kind });
    expect((await checked(task, withChange(text, hint!.change!))).passed).toBe(true);
  });

  it('looks neither at hidden worlds nor at the model solution, and tries no more than it may', async () => {
    const solution = [{ name: 'main.py', text: DRIVES }];
    const wrong = DRIVES.replace('forward', 'left');
    const hidden = { ...ahead.worlds[0], id: 'h', hidden: true, start: { at: [900, 450], heading: 0 } } as const;
    const plain = await hinted(ahead, wrong, 3);
    expect(plain?.tried).toBeLessThanOrEqual(3);
    expect(await hinted({ ...ahead, solution, worlds: [ahead.worlds[0], hidden] }, wrong, 3)).toEqual(plain);
  });
});

describe('the moment of a hint', () => {
  it('has the way until then, each point in its place', async () => {
    const hint = await hinted(ahead, DRIVES.replace('1100', '400'), 0);
    const { wayMm, pose } = hint!.moment!;
    expect(wayMm.length).toBeGreaterThan(5);
    const last = wayMm.at(-1)!;
    expect([Math.abs(last[0] - pose.xMm) < 1, Math.abs(last[1] - pose.yMm) < 1]).toEqual([true, true]);
    expect(wayMm.every(([x], place) => place === 0 || x >= wayMm[place - 1]![0])).toBe(true);
  });

  it('is said with the world, where the course as it is was passed', async () => {
    const other = { ...ahead.worlds[0], id: 'B', start: { at: [900, 450], heading: 0 } } as const;
    const hint = await hinted({ ...ahead, worlds: [ahead.worlds[0], other] }, DRIVES, 0);
    expect(hint).toMatchObject({ world: 'B', moment: null });
    expect(hintText(hint!, 1, 'en')).toMatch(/^In world B: /);
  });
});

describe('the levels of a hint', () => {
  const hint: Hint = {
    ...{
      reason: { code: 'open', params: {} },
      world: null,
      atMs: null,
      moment: null,
      tried: 7,
      program: 'a()\ndelay(650)\n',
    },
    happened: { fact: 'past', atS: 3.2, side: 'right', turns: 2, checkpoint: null },
    change: { kind: 'number', line: 2, before: ['delay(650)'], after: ['delay(780)'], direction: 'more' },
  };
  const told = (level: HintLevel) => JSON.parse(hintJson(hint, level, 'de')) as { readonly hint: object };

  it('tell the moment, the lines, the kind, the change', () => {
    expect(told(1)).toMatchObject({ passed: false, reason: 'open', found: true, tried: 7 });
    expect(told(1).hint).toEqual({
      ...{ level: 1, line: null, lines: [], direction: null },
      text: 'Nach der 2. Drehung fährt der Roboter rechts am Ziel vorbei.',
    });
    expect(told(2).hint).toMatchObject({ line: 2, lines: [2], direction: null });
    expect(told(3).hint).toMatchObject({ kind: 'number', direction: 'more' });
    expect(told(4)).toMatchObject({ change: { line: 2, before: 'delay(650)', after: 'delay(780)' } });
    for (const level of [1, 2, 3] as const) expect(told(level)).not.toHaveProperty('change');
    for (const level of [1, 2] as const) expect(told(level).hint).not.toHaveProperty('kind');
  });

  it('hold the change at level 4 alone, in every language', () => {
    for (const language of LANGUAGES) {
      for (const level of [1, 2, 3] as const) expect(hintText(hint, level, language)).not.toMatch(/780|delay/);
      expect(hintText(hint, 4, language)).toContain('delay(780)');
    }
  });

  it('say what was tried where nothing was found', () => {
    const text = hintText({ ...hint, change: null }, 3, 'en');
    expect(text).toMatch(/^After turn 2 .* 7 small changes were tried out/);
    expect(JSON.parse(hintJson({ ...hint, change: null }, 3, 'en'))).toMatchObject({
      found: false,
      hint: { line: null },
    });
  });
});
