import { describe, expect, it } from 'vitest';
import { boardTypes } from '#board/boards/index';
import { expectSame, made, type Made } from './testing/made-session';

const [type] = boardTypes;
if (type === undefined) throw new Error('There is no board.');
const [ofBoard] = type.firmwares;

const on = (program: string): Made => made(type, ofBoard, { 'main.py': program }, false);

/** Programs that leave a VM in many states: ended, in a call, in a `try`, deep in calls, with a full heap, reset, with things going on. */
const LEFT = [
  'print("here")',
  'from microbit import *\nwhile True:\n    try:\n        sleep(7)\n    finally:\n        pass\n',
  'def deep(n):\n    return deep(n + 1)\ntry:\n    deep(0)\nexcept RuntimeError as error:\n    print(error)\nwhile True: pass\n',
  'kept = []\nwhile True: kept.append(bytearray(100))\n',
  'import machine\nmachine.reset()\n',
  'import radio, music\nradio.on()\nmusic.play(music.NYAN, wait=False, loop=True)\nwhile True: radio.receive()\n',
];

const TO_SEE =
  'import gc, random\nfrom microbit import *\nfor n in range(30):\n    print([n] * random.randrange(40), gc.mem_free())\n    sleep(3)\n{}[n]\n';

/** The end of a program and all that can be seen of it. */
function played(one: Made): string {
  one.session.run(2_000_000);
  return `${one.printed()} ${one.clock.nowUs} ${one.board.display.pixels.join('')}`;
}

describe('a VM in memory that another one has used', () => {
  it.each(LEFT)('begins as one in new memory, after %j', (program) => {
    const fresh = on(TO_SEE); // nothing was given back: its memory is new
    const before = on(program);
    before.session.run(300_000);
    const { memory } = before.session['lent'];
    before.session.dispose();
    const after = on(TO_SEE);
    expect(after.session['lent'].memory).toBe(memory);
    expectSame(after, fresh);
    expect(played(after)).toBe(played(fresh));
    expectSame(after, fresh);
  });

  it('begins as one in new memory, after an error of ours in the midst of a call', () => {
    const fresh = on(TO_SEE);
    const before = on('from microbit import *\nfor n in range(9): display.show(n)\n');
    before.clock.advanceTo = () => {
      throw new Error('ours');
    };
    expect(before.session.run(300_000)).toBe('ended');
    before.session.dispose();
    const after = on(TO_SEE);
    expectSame(after, fresh);
    expect(played(after)).toBe(played(fresh));
  });

  it('does not go on once its memory was given back, and gives it back once', () => {
    const [one, other] = [on('while True: pass'), on('print(1)')];
    one.session.run(10_000);
    one.session.dispose();
    one.session.dispose();
    expect(one.session.run(20_000)).toBe('ended');
    expect(one.clock.nowUs).toBeLessThan(20_000);
    const [next, afterNext] = [on(''), on('')];
    expect(next.session['lent']).toBe(one.session['lent']);
    expect(afterNext.session['lent']).not.toBe(one.session['lent']);
    other.session.dispose();
  });
});
