import { describe, expect, it } from 'vitest';
import type { Carried } from '#project/project';
import { reasonText } from '../report/say';
import type { CheckResult } from '../result';
import { ahead, checked, sceneWith, targetAt, taskWith } from '../testing/tasks';

describe('why something is missed', () => {
  const wall = { type: 'wall', id: 'w', from: [900, 200], to: [900, 700], thickness: 10 } as const;
  const checks = [
    { type: 'stop', seconds: 1 },
    { type: 'touches', most: 0 },
    { type: 'console', text: 'done' },
  ];
  const task = taskWith(sceneWith([targetAt(700, 450), wall]), { checks: [{ type: 'goals' }, ...checks] });
  const codesOf = async (program: string) => {
    const result = await checked(task, program);
    const [world] = result.worlds;
    return [world?.reason?.code, ...result.checks.map(({ reason }) => reason?.code ?? 'held')];
  };

  it('is what ended the run, not what could not come any more', async () =>
    expect(await codesOf(ahead(9000))).toEqual(['touches', 'held', 'touches', 'touches', 'touches']));

  it('is the error that came before a robot without a program drove on into the wall', async () =>
    expect(await codesOf('from mbrobot import *\nforward()\nx = y\n')).toEqual([
      ...['exception', 'held', 'exception', 'touches', 'exception'],
    ]));

  it('is told of each where a program just ended too early', async () =>
    expect(await codesOf(ahead(3000))).toEqual(['console', 'held', 'held', 'console', 'console']));
});

describe('a goal that was not reached', () => {
  const goal = sceneWith([targetAt(700, 450)]);
  const say = ({ worlds }: CheckResult): string => reasonText(worlds[0]?.reason ?? { code: 'panic', params: {} }, 'en');
  const said = async (program: string, data: Carried = { seconds: 3 }, course = goal): Promise<string> =>
    say(await checked(taskWith(course, data), program));

  it('names an empty program, also one with only comments', async () =>
    expect(await said('\n# later\n')).toBe('The program is empty.'));

  it('names a robot that has never moved', async () => expect(await said('x = 1')).toBe('The robot never moved.'));

  it('names a program that waits for something that does not come', async () =>
    expect(await said(`from microbit import *\nwhile not button_a.is_pressed(): pass\n${ahead(4000)}`)).toBe(
      'The robot never moved: the program waits for “button_a”, which does not come in this task. The program was still running after 3 s, the limit of this check.',
    ));

  it('does not say that it waits for a button that the task presses', async () => {
    const inputs = [{ timeUs: 100_000, action: { type: 'button', button: 'a', down: true } }];
    const data = { seconds: 3, worlds: [{ id: 'visible', hidden: false, inputs }] };
    expect(await said('from microbit import *\nwhile not button_b.is_pressed(): pass\n', data)).toBe(
      'The robot never moved. The program was still running after 3 s, the limit of this check.',
    );
  });

  it('tells how near the robot came: 500 mm ahead is the middle of a field of 200 mm', async () => {
    const text = await said(ahead(500));
    expect(text).toMatch(/^The goal was not reached \(0 of 1\)\. The robot came as near as (2\d|3\d) cm\.$/);
  });

  it('tells when the robot left the line that leads there, and not where no line does', async () => {
    const line = { type: 'stroke', id: 'l', points: [[100, 450], [800, 450], [800, 850]], width: 30, color: 'black' } as const; // prettier-ignore
    const along = sceneWith([targetAt(800, 700), line]);
    expect(await said(ahead(4500), { seconds: 9 }, along)).toMatch(/^The goal was not reached \(0 of 1\)\. The robot left the line at \d\.\d s\. The robot came as near as \d+ cm\.$/); // prettier-ignore
    const beside = sceneWith([targetAt(800, 200), line]);
    expect(await said(ahead(4500), { seconds: 9 }, beside)).not.toContain('line');
    // Who only crosses a line does not follow it.
    const across = {
      ...line,
      points: [
        [700, 100],
        [700, 850],
      ],
    } as const;
    expect(await said(ahead(6000), { seconds: 7 }, sceneWith([targetAt(700, 700), across]))).not.toContain('line');
  });

  it('names the limit of the check where it was the end, and none where the program had ended', async () => {
    const endless = 'from mbrobot import *\nleft()\nwhile True: delay(10)\n';
    expect(await said(endless)).toBe(
      'The goal was not reached (0 of 1). The robot came as near as 40 cm. The program was still running after 3 s, the limit of this check.',
    );
  });

  it('within the time of the course, too', async () => {
    const timed = { ...goal, task: { ...goal.task, seconds: 2 } };
    expect(await said('while True: pass', {}, timed)).toBe('The robot never moved.');
    expect(await said(ahead(500), {}, timed)).toMatch(
      /^The time was over \(0 of 1 reached\)\. The course allows 2 s\. The robot came as near/,
    );
  });

  it('is reached after two minutes where neither course nor task has a limit', async () => {
    const late = `from mbrobot import *\ndelay(125000)\n${ahead(4000)}`;
    expect((await checked(taskWith(goal), late)).passed).toBe(true);
  });

  it('leaves what a check of the board lacks to that check', async () => {
    const checks = [{ type: 'goals' }, { type: 'console', text: 'done' }];
    const { worlds } = await checked(taskWith(goal, { checks, seconds: 2 }), 'while True: pass');
    expect(worlds[0]?.missed['console']).toEqual({ code: 'console', params: { text: 'done', limit: 2 } });
  });
});

describe('an error of the program', () => {
  const task = taskWith(sceneWith([targetAt(700, 450)]));
  const said = async (program: string, language: 'de' | 'en'): Promise<string> => {
    const { worlds } = await checked(task, program);
    return reasonText(worlds[0]?.reason ?? { code: 'panic', params: {} }, language);
  };

  it('is told with the advice of the console: a loop of another Python', async () =>
    expect(await said('from mbrobot import *\nrepeat 4:\n    forward()\n', 'en')).toBe(
      'Line 2: SyntaxError: invalid syntax – repeat belongs to TigerJython. Here you write: for i in range(4):',
    ));

  it('is explained in the language of the reader', async () =>
    expect(await said('x = 1\nif x == 1\n    x = 2\n', 'de')).toMatch(
      /^Zeile 3: SyntaxError: invalid syntax – In Zeile 2 .*Doppelpunkt/,
    ));

  it('has nothing to add to what it does not know', async () =>
    expect(await said('class Lost(Exception): pass\nraise Lost("here")\n', 'en')).toBe('Line 2: Lost: here'));
});
