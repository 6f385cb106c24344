import { describe, expect, it } from 'vitest';
import { deviceWith, runProgram } from './testing/run-program';

const TAKEN = `
import time
L = list(range(300))
S = 'abcdefghij' * 50
B = 3 ** 1000
def us(f):
    before = time.ticks_us()
    f()
    return time.ticks_us() - before
`;

/** The simulated µs that an expression takes. */
const usOf = (expression: string): number => Number(runProgram(`${TAKEN}print(us(lambda: ${expression}))`).console);

describe('work inside one call of MicroPython’s C', () => {
  it.each([
    ['sum(range(100))', 'sum(range(1000))', 9, 11],
    ['list(range(100))', 'list(range(1000))', 7, 11],
    ['max(L[:30])', 'max(L)', 5, 11],
    ['999 in L[:30]', '999 in L', 5, 11],
    ['sorted(L[:30], reverse=True)', 'sorted(L, reverse=True)', 40, 110],
    ["S[:50].find('x')", "S.find('x')", 3, 11],
    ["S[:50].count('x')", "S.count('x')", 3, 11],
    ['B ** 2', 'B ** 8', 4, 60],
    ["','.join(['ab'] * 30)", "','.join(['ab'] * 300)", 4, 11],
    ['bytes(S, "ascii") * 2', 'bytes(S, "ascii") * 20', 4, 11],
    ['S[:50].format()', 'S.format()', 4, 11],
    ['S[:50] % ()', 'S % ()', 4, 11],
    ['B * 3 ** 10', 'B * B', 4, 60],
    ['str(3 ** 100)', 'str(B)', 15, 120],
  ])('takes longer the more it is: %s and %s', (little, much, least, most) => {
    const empty = usOf('None');
    const ratio = (usOf(much) - empty) / (usOf(little) - empty);
    expect(ratio).toBeGreaterThan(least);
    expect(ratio).toBeLessThan(most);
  });

  it('takes some 30 µs to write a decimal number', () => {
    expect(usOf('str(1.5)') - usOf("str('a')")).toBeGreaterThan(25);
    expect(usOf('str(1.5)') - usOf("str('a')")).toBeLessThan(60);
  });

  it('takes longer for a collection that is asked for, the more lives', () => {
    const usToCollect = (lives: string): number =>
      Number(runProgram(`${TAKEN}import gc\nL = S = B = None\nX = ${lives}\nprint(us(gc.collect))`).console);
    const little = usToCollect('None');
    const much = usToCollect('[[n] for n in range(500)]');
    expect(little).toBeGreaterThan(1000);
    expect(little).toBeLessThan(2000);
    expect(much - little).toBeGreaterThan(900);
    expect(much - little).toBeLessThan(2500);
  });

  it('takes the time of its collections where a program wants one with each allocation, and no more after it', () => {
    const spent = (before: string): number =>
      Number(
        runProgram(`${TAKEN}import gc\n${before}\ndef f():\n    for i in range(100): [0] * 10\nprint(us(f))`).console,
      );
    const plain = spent('pass');
    expect(spent('gc.threshold(1)') / 100).toBeGreaterThan(1300);
    expect(spent('gc.threshold(1)') / 100).toBeLessThan(6 * 1400);
    expect(spent('gc.threshold(1)\ngc.threshold(-1)')).toBe(plain);
    expect(runProgram('import gc\nprint(gc.threshold())\ngc.threshold(64)\nprint(gc.threshold())').console).toMatch(
      /^-?\d+\s+64\s/,
    );
  });

  it('can be suspended in the middle, and comes to the same end at the same time', () => {
    const program = `${TAKEN}
print(sum(range(3000)), sorted(L, reverse=True)[0], str(B)[:5], len(','.join(str(n) for n in L)))
print(time.ticks_us())`;
    const whole = runProgram(program);
    for (const sliceUs of [10_000, 485, 17]) {
      const sliced = runProgram(program, { sliceUs });
      expect(sliced).toEqual(whole);
    }
  });

  it('ends in the middle when its time is over, however much is left to do', () => {
    const { vm, clock } = deviceWith('sum(range(10 ** 9))');
    vm.resume(50_000);
    expect(clock.nowUs).toBe(50_000);
    expect(vm.ended).toBeNull();
  });
});
