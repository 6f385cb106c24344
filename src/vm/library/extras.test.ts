import { describe, expect, it } from 'vitest';
import { LATER, linesOf, play } from './testing/play';

describe('modules with a surprise', () => {
  it('this prints when it is imported for the first time, and never again', () => {
    const lines = linesOf('import this\nn = 1\nimport this\nprint("-")\nthis.authors()');
    expect(lines[0]).toBe('Small board, small program, big idea.');
    expect(lines.filter((line) => line.startsWith('Small board'))).toHaveLength(1);
    expect(lines[lines.indexOf('-') + 1]).toContain('Damien P. George');
  });

  it('love lets a heart beat 8 times: 4.3 s', () => {
    // micropython-microbit-v2 modlove.c: 8 beats of 14 pictures of 25 ms, three pauses of 500 ms
    expect(linesOf('t = running_time()\nimport love\nprint((running_time() - t) // 100)')).toEqual(['43']);
    expect(linesOf('import love\nt = running_time()\nlove.badaboom()\nprint((running_time() - t) // 100)')).toEqual([
      '43',
    ]);
  });

  it('antigravity lifts what is on the display, one row every 200 ms', () => {
    const run = play(
      'from microbit import *\ndisplay.set_pixel(2, 4, 9)\nimport antigravity\nprint(display.get_pixel(2, 0), running_time() // 100)',
    ).until(5000);
    expect(run.printed()).toContain('MicroPython!');
    expect(run.printed()).toMatch(/\n9 1\d\n$/);
  });
});

describe('the names of modules', () => {
  it('are shown with u by MicroPython before 1.19', () => {
    const program =
      'import array, collections, errno, random, struct\nprint(array, collections, errno, random, struct, random.__name__)';
    const shown = (letter: string): string =>
      ['array', 'collections', 'errno', 'random', 'struct'].map((name) => `<module '${letter}${name}'>`).join(' ');
    expect(linesOf(program)).toEqual([`${shown('u')} urandom`]);
    for (const device of LATER) expect(linesOf(program, {}, undefined, device)).toEqual([`${shown('')} random`]);
  });

  it('leave out what is ours from those of micropython', () => {
    expect(linesOf("import micropython\nprint(hasattr(micropython, 'free'), OSError(28))")).toEqual([
      'False [Errno 28] ENOSPC',
    ]);
  });

  it('have the old ones with u too, where the device has them', () => {
    const program = `
for name in 'uarray ucollections uerrno uos urandom ustruct usys utime'.split():
    __import__(name)
print('all')`;
    expect(linesOf(program)).toEqual(['all']);
  });

  it.each(['ure', 'ujson', 'json', 'asyncio', 'uctypes', 'io'])('does not have %s', (name) => {
    expect(linesOf(`err(__import__, '${name}')`)).toEqual([`ImportError: no module named '${name}'`]);
  });
});
