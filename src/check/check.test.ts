import { describe, expect, it } from 'vitest';
import type { Project } from '#project/project';
import { defaultScene, type SceneObject } from '#scene/scene';
import { check } from './check';
import { handInOfFiles } from './hand-in/read-hand-in';
import { taskOf } from './task/read-task';
import type { ClassTask } from './task/task';
import { ahead, checked, checkedProject, checkpointAt, firmware, projectWith, readyScene, readySolution, sceneWith, targetAt, taskWith } from './testing/tasks'; // prettier-ignore

const goal = sceneWith([targetAt(700, 450)]);
const toGoal = ahead(4000);

describe('a hand-in for a course with goals', () => {
  it('passes as soon as the goals are reached, and is run no longer', async () => {
    const result = await checked(taskWith(readyScene('closed-line')), readySolution('closed-line'));
    expect(result).toMatchObject({ passed: true, points: 1, stars: null, remarks: [] });
    expect(result.worlds).toEqual([
      expect.objectContaining({
        id: 'visible',
        hidden: false,
        passed: true,
        reason: null,
        touches: 0,
        held: ['goals'],
      }),
    ]);
    expect(result.worlds[0]?.atMs).toBeGreaterThan(15_000);
  });

  it('has its way with the time of each point: from 0 on, never back, until it was decided', async () => {
    const { worlds } = await checked(taskWith(goal), toGoal);
    const { trail, trailMs, atMs } = worlds[0]!;
    const times = trailMs.flat();
    expect(trailMs.map(({ length }) => length)).toEqual(trail.map(({ length }) => length));
    expect(times[0]).toBeLessThan(100);
    expect(times.toSorted((one, other) => one - other)).toEqual(times);
    expect(Math.abs(times.at(-1)! - atMs!)).toBeLessThan(100);
  });

  it('gives the same result twice, to the last bit', async () => {
    const task = taskWith(goal);
    expect(await checked(task, toGoal)).toEqual(await checked(task, toGoal));
  });

  it('fails if the robot stops too early; nothing moves any more, so the time limit is not awaited', async () => {
    const result = await checked(taskWith(goal), ahead(500));
    expect(result.passed).toBe(false);
    const reason = { code: 'open', params: { done: 0, of: 1, near: expect.any(Number) as number } };
    expect(result.worlds[0]).toMatchObject({ atMs: null, reason });
  });

  it('reports an error in the words of the board', async () => {
    const { worlds } = await checked(taskWith(goal), 'x = 1\nprint(y)\n');
    expect(worlds[0]?.reason).toEqual({
      code: 'exception',
      params: { type: 'NameError', message: "name 'y' isn't defined", line: 2 },
      advice: expect.objectContaining({ en: expect.stringContaining('y') as string }) as object,
    });
  });

  it('ends after the seconds of the task if it never ends by itself', async () => {
    let beats = 0;
    const beat = (): void => {
      beats += 1;
    };
    const endless = 'while True:\n    pass\n';
    const { worlds } = await checked(taskWith(goal, { seconds: 2 }), endless, { beat });
    expect(worlds[0]?.reason).toEqual({ code: 'unmoved', params: { limit: 2 } });
    expect(beats).toBe(21);
  });

  it.each([2.01, 4.1])('ends after %d s, too, which no clock of whole µs can represent exactly', async (seconds) => {
    let beats = 0;
    const beat = (): void => {
      beats += 1;
      if (beats > 100) throw new Error('The run goes on and on.');
    };
    const { worlds } = await checked(taskWith(goal, { seconds }), 'while True:\n    pass\n', { beat });
    expect(worlds[0]?.reason).toEqual({ code: 'unmoved', params: { limit: seconds } });
  });

  it('costs nothing but its time if it prints, eats memory or recurses without end', async () => {
    const task = taskWith(goal, { seconds: 1 });
    const codes = [];
    for (const program of [
      'while True: print("x" * 10000)',
      'a = []\nwhile True: a.append(bytes(1000))',
      'def f(): f()\nf()',
    ])
      codes.push((await checked(task, program)).worlds[0]?.reason);
    expect(codes.map((reason) => [reason?.code, reason?.params['type']])).toEqual([
      ['unmoved', undefined],
      ['exception', 'MemoryError'],
      ['exception', 'RuntimeError'],
    ]);
  });

  it('tells why the goals failed, and what was touched', async () => {
    const wall = { type: 'wall', id: 'w', from: [500, 300], to: [500, 600], thickness: 10 } as const;
    const scene = sceneWith([targetAt(700, 450), wall], { task: { seconds: null, noTouch: true } });
    const { worlds } = await checked(taskWith(scene), toGoal);
    expect(worlds[0]).toMatchObject({ passed: false, touches: 1, reason: { code: 'touched', params: { by: 'w' } } });
  });

  it('is run on the course of the task, whatever course the pupil has; that is told', async () => {
    const easy = { ...goal, objects: [targetAt(200, 450)] };
    const result = await checkedProject(taskWith(goal), projectWith(easy, ahead(100)));
    expect(result.passed).toBe(false);
    expect(result.remarks).toEqual([{ code: 'course', params: {} }]);
    const named = { ...goal, name: 'Anna' };
    expect((await checkedProject(taskWith(goal), projectWith(named, toGoal))).remarks).toEqual([]);
  });

  it('is on the same course where a link had no room for its picture', async () => {
    const grid = { at: [0, 0], size: [100, 100], cells: [1, 1], levels: 'AA==' } as const;
    const withPicture = (picture: string) => ({ ...goal, background: { ...grid, picture } });
    const seen = taskWith(withPicture('data:image/png;base64,AA=='));
    expect((await checkedProject(seen, projectWith(withPicture(''), toGoal))).remarks).toEqual([]);
  });

  it('is reported and is nobody’s duplicate if it was handed out like that', async () => {
    const result = await checked(taskWith(goal), '');
    expect(result).toMatchObject({ passed: false, remarks: [{ code: 'unchanged' }], twin: '' });
  });

  it('is nobody’s twin, and not as it was handed out, where only that of a further device differs', async () => {
    const hardware = { device: 'auto', firmware: '', robot: 'none', robotOptions: {}, sameAs: '' } as const;
    const withRemote = (text: string): Project => ({
      ...projectWith(goal),
      devices: { first: 'robot', others: [{ ...hardware, name: 'remote', files: [{ name: 'main.py', text }] }] },
    });
    const read = taskOf(withRemote(''));
    if ('problem' in read) throw new Error(read.problem);
    const result = (text: string) => checkedProject(read.task, withRemote(text));
    const [given, one, renamed, other] = await Promise.all(['', 'a = 1', 'b = 1', 'a = 2'].map(result));
    expect(given).toMatchObject({ remarks: [{ code: 'unchanged' }], twin: '' });
    expect([one?.remarks, one?.twin === renamed?.twin, one?.twin === other?.twin]).toEqual([[], true, false]);
  });
});

describe('what a pupil’s page says', () => {
  const said = {
    version: 1,
    task: 'a',
    alias: 'Anna',
    verdict: 'passed',
    tries: 3,
    hash: '',
    remarks: ['hand', 'outside'],
  };
  const task = taskWith(goal, { id: 'a' });
  const hashOf = async (of: ClassTask): Promise<string> => (await checked(of, toGoal)).worlds[0]?.hash ?? '';
  /** The page has run what it hands in, unless something else is said. */
  const remarksOf = async (change: object, program = toGoal): Promise<readonly string[]> => {
    const handIn = { ...said, hash: await hashOf(task), ...change };
    return (await checkedProject(task, { ...projectWith(goal, program), handIn })).remarks.map(({ code }) => code);
  };

  it('is told: the hand, a program from elsewhere, another task', async () => {
    expect(await remarksOf({})).toEqual(['hand', 'outside']);
    expect(await remarksOf({ task: 'b', remarks: [] })).toEqual(['other-task']);
  });

  it('is told where a line is missing that the page locks, also of a program alone', async () => {
    const start = `# locked\n${toGoal}`;
    const locked = { ...taskWith(goal, { locks: { lines: [1] } }), project: projectWith(goal, start) };
    expect((await checked(locked, `# mine\r\n${start}`)).remarks).toEqual([]);
    expect((await checked(locked, `# mine\n${toGoal}`)).remarks).toEqual([{ code: 'outside', params: {} }]);
  });

  it('is told where the page did not keep what the task locks', async () => {
    const locks = { hand: true, speed: 4, tools: ['pen'], lines: [1] };
    const locked = taskWith(goal, { locks });
    const remarks = async (data?: object): Promise<readonly string[]> => {
      const handIn = { ...said, hash: await hashOf(locked), task: '', remarks: [] };
      const project = { ...projectWith(goal, toGoal), handIn, ...data };
      return (await checkedProject(locked, project)).remarks.map(({ code }) => code);
    };
    const given = (those: object, handedOut = true) => ({ task: { version: 1, handedOut, locks: those } });
    expect(await remarks(given({ ...locks, lines: [3] }))).toEqual([]);
    expect(await remarks(given({ ...locks, course: true, tools: true }))).toEqual([]);
    for (const freed of [
      undefined,
      given(locks, false),
      given({ ...locks, hand: false }),
      given({ ...locks, speed: 8 }),
      given({ ...locks, tools: ['pen', 'eraser'] }),
    ])
      // prettier-ignore
      expect(await remarks(freed)).toEqual(['unlocked']);
    expect((await checkedProject(locked, projectWith(goal, toGoal))).remarks).toEqual([]);
  });

  it('is proved by the run: a verdict that it has not, a way that it has not gone', async () => {
    expect(await remarksOf({ remarks: [] }, ahead(100))).toEqual(['verdict']);
    expect(await remarksOf({ remarks: [] })).toEqual([]);
    expect(await remarksOf({ remarks: [], hash: 'f'.repeat(64) })).toEqual(['hash']);
  });

  it('is not without the fingerprint of its run, unless nobody has run it', async () => {
    const without = { remarks: [], hash: '' };
    for (const verdict of ['passed', 'failed']) expect(await remarksOf({ ...without, verdict })).toEqual(['no-hash']);
    expect(await remarksOf({ ...without, verdict: 'open' })).toEqual([]);
    expect((await checked(task, toGoal)).remarks).toEqual([]);
  });

  it('is of another run where a recorded one was changed in its file', async () => {
    const edited = { ...handInOfFiles([{ name: 'main.py', text: toGoal }]), isEdited: true } as const;
    expect((await check(task, edited, { firmware: firmware() })).remarks).toEqual([{ code: 'edited', params: {} }]);
  });
});

describe('a task with several worlds', () => {
  it('wants the visible and all hidden ones', async () => {
    const far = { id: 'far', start: { at: [100, 450] } };
    const turned = { id: 'turned', start: { at: [200, 450], heading: 180 } };
    const result = await checked(taskWith(goal, { worlds: [far, turned] }), toGoal);
    expect(result.worlds.map(({ id, hidden, passed }) => [id, hidden, passed])).toEqual([
      ['visible', false, true],
      ['far', true, true],
      ['turned', true, false],
    ]);
    expect(result).toMatchObject({ passed: false, points: 0 });
    expect((await checked(taskWith(goal, { worlds: [far, turned], least: 1 }), toGoal)).passed).toBe(true);
  });

  it('differ by seed and reality, sensors, inputs and things of the course', async () => {
    const worlds = [
      { id: 'used', reality: 1, seed: 7 },
      { id: 'dark', sensors: { lightLevel: 3 } },
      { id: 'pressed', inputs: [{ timeUs: 500_000, action: { type: 'button', button: 'a', down: true } }] },
      { id: 'moved', edits: [{ type: 'remove', ids: ['t'] }, { type: 'add', objects: [{ id: 't2', type: 'target', at: [100, 100], size: [50, 50] }] }] }, // prettier-ignore
    ];
    const program = `from microbit import *\n${toGoal}print(display.read_light_level(), button_a.was_pressed())\n`;
    const checks = [{ type: 'goals' }, { type: 'console', text: '3 False' }, { type: 'console', text: ' True' }];
    const result = await checked(taskWith(goal, { worlds, checks }), program);
    const held = Object.fromEntries(result.worlds.map((world) => [world.id, world.held.join(' ')]));
    expect(held).toEqual({
      ...{ visible: 'goals', used: 'goals', dark: 'goals console', pressed: 'goals console-2', moved: '' },
    });
    expect(new Set(result.worlds.map(({ hash }) => hash)).size).toBe(2); // only a used robot drives otherwise
  });

  it('says so if nothing can run in it', async () => {
    const worlds = [{ id: 'out', start: { at: [5000, 450] } }];
    const { worlds: results } = await checked(taskWith(goal, { worlds }), toGoal);
    expect(results[1]?.reason).toMatchObject({ code: 'refused' });
  });

  it('is not run where the program was stuck before', async () => {
    const lost = { from: 1, reason: { code: 'stuck', params: {} } } as const;
    const { worlds } = await checked(taskWith(goal, { worlds: [{ id: 'w' }] }), toGoal, { lost });
    expect(worlds.map(({ passed, reason }) => [passed, reason?.code])).toEqual([
      [true, undefined],
      [false, 'stuck'],
    ]);
  });
});

describe('a task gives', () => {
  const checks = [
    { type: 'goals', points: 2 },
    { type: 'faster', seconds: 1, needed: false, points: 3 },
    { type: 'loop', needed: false },
  ];

  it('points for each check that holds, and stars by points', async () => {
    const task = taskWith(goal, { checks, stars: [3, 6] });
    const of = async (program: string) => {
      const { passed, points, stars } = await checked(task, program);
      return [passed, points, stars];
    };
    expect(await of(toGoal)).toEqual([true, 2, 1]);
    expect(await of(`${toGoal}for i in []: pass\n`)).toEqual([true, 3, 2]);
    expect(await of('for i in []: pass\n')).toEqual([false, 1, 0]);
  });

  it('counts what is required for those who have reached everything, not for those who have done nothing', async () => {
    const task = taskWith(goal, { checks: [{ type: 'goals' }, { type: 'touches', most: 0 }] });
    expect((await checked(task, 'x = 1')).points).toBe(0);
    expect((await checked(task, toGoal)).points).toBe(2);
  });

  it('touches count until everything is reached, also after the goals of the course', async () => {
    const wall = { type: 'wall', id: 'w', from: [900, 200], to: [900, 700], thickness: 10 } as const;
    const checks = [{ type: 'goals' }, { type: 'touches', most: 0 }, { type: 'console', text: 'done' }];
    const task = taskWith(sceneWith([targetAt(700, 450), wall]), { checks });
    const done = "print('done')\n";
    expect(await checked(task, ahead(3000) + done)).toMatchObject({ passed: true, worlds: [{ touches: 0 }] });
    const { passed, worlds } = await checked(task, ahead(9000) + done);
    expect(passed).toBe(false);
    expect(worlds[0]).toMatchObject({ touches: 1, reason: { code: 'touches', params: { count: 1, most: 0 } } });
  });
});

describe('rounds and checkpoints', () => {
  it('count in their order, or in any', async () => {
    const scene = sceneWith([checkpointAt(400, 450, 2), checkpointAt(700, 450, 1)]);
    const task = taskWith(scene, {
      checks: [{ type: 'checkpoints' }, { type: 'laps', count: 1, needed: false }],
      seconds: 8,
    });
    const { passed, worlds } = await checked(task, toGoal);
    expect(passed).toBe(true);
    expect(worlds[0]?.missed).toEqual({ laps: { code: 'laps', params: { done: 0, of: 1 } } });
  });

  it('count on the closed line: two rounds take twice as long as one', async () => {
    const scene = readyScene('closed-line');
    const endless = readySolution('closed-line');
    const one = await checked(taskWith(scene, { checks: [{ type: 'laps', count: 1 }] }), endless);
    const two = await checked(taskWith(scene, { checks: [{ type: 'laps', count: 2 }] }), endless);
    expect([one.passed, two.passed]).toEqual([true, true]);
    const [first, second] = [one.worlds[0]?.atMs ?? 0, two.worlds[0]?.atMs ?? 0];
    expect(second / first).toBeGreaterThan(1.8);
    expect(second / first).toBeLessThan(2.2);
  });
});

describe('a round', () => {
  const line = (x: number, id = 't'): SceneObject => ({ ...targetAt(x, 450, id), size: [100, 200], round: false });
  const start = (x: number): SceneObject => ({
    ...targetAt(x, 450, 's'),
    size: [100, 200],
    round: false,
    type: 'checkpoint',
    number: 1,
  });
  const lapsOf = async (objects: readonly SceneObject[], program: string) => {
    const checks = [{ type: 'laps', count: 3 }];
    const { passed, worlds } = await checked(taskWith(sceneWith(objects), { checks, seconds: 20 }), program);
    return [passed, worlds[0]?.missed['laps']?.params['done']];
  };
  const backAndForth = `from mbrobot import *
while True:
    forward(); delay(1500)
    backward(); delay(1500)
`;

  it('is none where the robot stands in the only field', async () =>
    expect(await lapsOf([start(200)], 'from mbrobot import *\nleft()\ndelay(3000)\nstop()\n')).toEqual([false, 0]));

  it('is one where a line is crossed once, also through two fields that overlap', async () => {
    expect(await lapsOf([line(400)], ahead(2500))).toEqual([false, 1]);
    expect(await lapsOf([start(400), line(420)], ahead(2500))).toEqual([false, 1]);
  });

  it('counts again after the field was left', async () => {
    expect(await lapsOf([line(400)], backAndForth)).toEqual([true, undefined]);
    expect(await lapsOf([start(200)], backAndForth)).toEqual([true, undefined]);
  });
});

describe('a check sees each step that the goals see', () => {
  it.each([
    [1, 5, [500, 597, 694, 791, 888, 985]],
    [3, 20, [500, 711, 922, 1133, 1344, 1555]],
  ])('at size %d: gates of %d mm at full speed', async (scale, width, places) => {
    const gates = places.map((x, at): SceneObject => ({
      ...{ ...checkpointAt(x, 450, 1), id: `c${String(at)}`, size: [width, 300], round: false },
    }));
    const scene = sceneWith(gates, { size: [2600, 900], robot: { ...defaultScene().robot, at: [200, 450], scale } });
    const task = taskWith(scene, { checks: [{ type: 'goals' }, { type: 'checkpoints' }], seconds: 8 });
    const { worlds } = await checked(task, 'from mbrobot import *\nsetSpeed(100)\nforward()\ndelay(6000)\n');
    expect(worlds[0]?.held).toEqual(['goals', 'checkpoints']);
  });

  it.each([500, 509, 518, 527, 568])('a touch right after the target at %d mm does not count', async (x) => {
    const field: SceneObject = { ...targetAt(x, 450), size: [100, 200], round: false };
    const wall = { type: 'wall', id: 'w', from: [x + 18, 200], to: [x + 18, 700], thickness: 10 } as const;
    const checks = [{ type: 'goals' }, { type: 'touches', most: 0 }];
    const program = 'from mbrobot import *\nsetSpeed(100)\nforward()\ndelay(3000)\nstop()\n';
    const { passed, worlds } = await checked(taskWith(sceneWith([field, wall]), { checks }), program);
    expect([passed, worlds[0]?.touches]).toEqual([true, 0]);
  });
});

describe('what board and robot show', () => {
  const shows = async (check: object, program: string): Promise<boolean> =>
    (await checked(taskWith(sceneWith([]), { checks: [check], seconds: 10 }), program)).passed;

  it.each([
    [{ type: 'stop', seconds: 1 }, ahead(500), 'x = 1'],
    [{ type: 'display', image: '09090:99999:99999:09990:00900' }, 'from microbit import *\ndisplay.show(Image.HEART)', 'from microbit import *\ndisplay.show(Image.HAPPY)'], // prettier-ignore
    [{ type: 'light', which: 'left' }, 'from mbrobot import *\nsetLED(1)\n', 'x = 1'],
    [
      { type: 'light', which: 'left', color: 'blue' },
      'from mbrobot_plusV3 import *\nsetLEDLeft(4)\n',
      'from mbrobot_plusV3 import *\nsetLEDRight(4)\n',
    ],
    [{ type: 'sound', hz: 440 }, 'import music\nmusic.pitch(440, 100)', 'import music\nmusic.pitch(523, 100)'],
    [{ type: 'sound' }, 'import music\nmusic.pitch(523, 100)', 'x = 1'],
    [{ type: 'console', text: 'hello' }, 'print("hel", end="")\nprint("lo")', 'print("hallo")'],
    [
      { type: 'radio', text: 'go' },
      'import radio\nradio.on()\nradio.send("go")',
      'import radio\nradio.on()\nradio.send("no")',
    ],
    [{ type: 'log', rows: 2, column: 'a' }, 'import log\nfor i in range(2): log.add(a=i)', 'import log\nlog.add(a=1)'],
    [{ type: 'touches', most: 0 }, 'x = 1', ahead(9000)],
  ])('%j', async (asked, right, wrong) => {
    expect([await shows(asked, right), await shows(asked, wrong)]).toEqual([true, false]);
  });
});
