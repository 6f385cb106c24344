import { describe, expect, it } from 'vitest';
import type { Bench } from '#board/testing/bench';
import { linesOf, play, type Play } from './testing/play';

const logged = (run: Play): string => run.bench.board.dataLog.csv;

describe('log', () => {
  it('adds rows with seconds since the start, two decimals', () => {
    const run = play(`
from microbit import *
import log
log.add(a=1)
sleep(1500)
log.add({'a': 2.5, 'b': 'x'})
sleep(10000)
log.add(b=True)`);
    expect(logged(run.until(12_000))).toBe('Time (seconds),a\n0.00,1\nTime (seconds),a,b\n1.50,2.5,x\n11.50,,True\n');
  });

  it('takes 1.4 ms for a row of 30 bytes, for it goes to the chip behind the USB socket', () => {
    const program = `
import log, time
log.set_labels('text', timestamp=None)
log.add(text='')
t = time.ticks_us()
log.add(text='x' * 29)
print(round(time.ticks_diff(time.ticks_us(), t), -1))`;
    // 17 bytes of order and answer and the 30 at 22.5 µs, and 7.5 words of flash memory at 42.5 µs: 1376 µs, and the call.
    const [us] = linesOf(program).map(Number);
    expect(us).toBeGreaterThan(1376);
    expect(us).toBeLessThan(1376 + 100);
  });

  it('is emptied when a program writes a new main.py, and by no other file', () => {
    const run = play(`
import log
log.add(a=1)
open('data.txt', 'w').close()
open('main.py').close()
from time import sleep
sleep(1)
open('main.py', 'w').close()`);
    expect(logged(run.until(900))).toBe('Time (seconds),a\n0.00,1\n');
    expect(logged(run.until(2000))).toBe('');
  });

  it('has its columns in the order in which they are written', () => {
    const run = play(`
import log
log.add(x=1, y=2, z=3)
log.add(temperature=1, light=2, sound=3, heading=4)`);
    const [first, , second] = logged(run.until(100)).split('\n');
    expect([first, second]).toEqual(['Time (seconds),x,y,z', 'Time (seconds),x,y,z,temperature,light,sound,heading']);
  });

  it('sets labels and the unit of the timestamp', () => {
    const run = play(`
from microbit import *
import log
log.set_labels('b', 'a', timestamp=log.MINUTES)
sleep(30000)
log.add(a=1)
log.set_labels(timestamp=None)
log.add(b=2)
log.set_labels('c')
log.add(c=3)`);
    expect(logged(run.until(31_000))).toBe(
      'Time (minutes),b,a\n0.50,,1\n,2,\nTime (minutes),b,a,c,Time (seconds)\n,,,3,30.00\n',
    );
  });

  it('refuses what is no row', () => {
    const program = `
import log
err(log.add, 5)
err(log.add, {}, {})
err(log.add, {1: 2})
err(log.add, a=None)
err(log.add, a=[1])
err(log.set_labels, 1)
err(log.set_labels, timestamp='s')
err(log.set_labels, timestamp=5)
print(log.MILLISECONDS, log.SECONDS, log.MINUTES, log.HOURS, log.DAYS)`;
    expect(linesOf(program)).toEqual([
      'ValueError: expecting a dict',
      'ValueError: too many arguments',
      "TypeError: can't convert 'int' object to str implicitly",
      "TypeError: can't convert 'NoneType' object to str implicitly",
      "TypeError: can't convert 'list' object to str implicitly",
      "TypeError: can't convert 'int' object to str implicitly",
      "TypeError: can't convert str to int",
      'no error: None',
      '1 10 600 36000 864000',
    ]);
  });

  it('writes a row that a mistake has cut off when the next one begins', () => {
    const run = play(`
import log
log.set_labels('a', 'b', timestamp=None)
try:
    log.add(a=1, b=None, c=5)
except TypeError:
    pass
log.add(a=2, b='x\\0y')
try:
    log.set_labels('d', 5, timestamp=None)
except TypeError:
    pass
log.set_labels('e', timestamp=None)`);
    expect(logged(run.until(100))).toBe('a,b\n1,\n2,x\na,b,d\na,b,d,e\n');
  });

  it('takes any unit: one without a name has hundredths, too', () => {
    const run = play(`
from microbit import sleep
import log
log.set_labels('a', timestamp=5)
sleep(1000)
log.add(a=1)`);
    expect(logged(run.until(2000))).toBe('Time (),a\n2.00,1\n');
  });

  it('prints what it logs while it mirrors', () => {
    const program = `
import log
log.set_mirroring(True)
log.set_labels('a', timestamp=None)
log.add(a=1)
log.set_mirroring(False)
log.add(a=2)`;
    expect(linesOf(program)).toEqual(['a', '1']);
  });

  it('is full after 118,780 bytes: ENOSPC, until it is deleted', () => {
    const program = `
import log
log.set_labels(timestamp=None)
n = 0
try:
    while True:
        log.add(a='x' * 1000)
        n += 1
except OSError as e:
    print(n, e)
err(log.add, a='x' * 1000)
log.delete()
log.add(a=1)
log.delete(full=True)`;
    expect(linesOf(program)).toEqual(['118 [Errno 28] ENOSPC', 'OSError: [Errno 28] ENOSPC']);
  });

  it('outlives a reset and goes on in the same columns', () => {
    const run = play(`
import os, log, microbit
log.add(a=1)
if 'seen' not in os.listdir():
    open('seen', 'w').close()
    microbit.reset()`);
    expect(logged(run.until(3000))).toBe('Time (seconds),a\n0.00,1\n0.00,1\n');
  });

  it('tells the outside', () => {
    const events: unknown[] = [];
    const setUp = ({ board }: Bench): void => void board.dataLog.onEvent((event) => events.push(event));
    play('import log\nlog.add(a=1)\nlog.delete()', {}, setUp).until(100);
    expect(events).toEqual([
      { type: 'row', headings: ['Time (seconds)', 'a'], values: ['0.00', '1'] },
      { type: 'clear' },
    ]);
  });
});
