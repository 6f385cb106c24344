import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

describe('run_every', () => {
  it('calls its function while the program sleeps, and sleep takes as long as it should', () => {
    const program = `
n = 0
@run_every(ms=20)
def tick():
    global n
    n += 1
print(took(sleep, 1000), 48 <= n <= 51)`;
    expect(linesOf(program)).toEqual(['1000 True']);
  });

  it('calls its function while the program spins', () => {
    const program = `
n = 0
def tick():
    global n
    n += 1
run_every(tick, s=1)
while n < 3:
    pass
print(running_time() // 100)`;
    expect(linesOf(program)).toEqual(['30']);
  });

  it('goes on during a sleep, a melody and input', () => {
    const run = play(`
from microbit import *
import music, time
n = 0
@run_every(ms=100)
def tick():
    global n
    n += 1
def count(f, *a):
    before = n
    f(*a)
    print(n > before + 3)
count(sleep, 1000)
count(time.sleep, 1)
count(music.play, 'c:16')
count(input)`);
    run.until(15_000).vm.feed('x\r');
    expect(run.until(25_000).printed()).toBe('True\nTrue\nTrue\nx\nTrue\n');
  });

  it.each([
    "display.scroll('hello')",
    "display.show('abcd', 300)",
    'display.show([Image.HEART] * 4, 300)',
    'machine.time_pulse_us(pin1, 1, 1020000)',
    'time.sleep_us(1020000)',
  ])('waits as on the device while the program waits in %s: four calls are kept, and run at its next jump', (call) => {
    const program = `
import machine, time
n = 0
@run_every(ms=50)
def tick():
    global n
    n += 1
while n < 1:
    pass
before = n
${call}
after = n
sleep(10)
print(after - before, n - after)`;
    expect(linesOf(program)).toEqual(['0 4']);
  });

  it('raises the error of a callback when the text has scrolled through', () => {
    const run = play(`
from microbit import *
@run_every(ms=100)
def tick():
    nothing
display.scroll('hello')
print(running_time() // 100)
sleep(20)
print('on')`).until(9000);
    expect(run.printed().split('\n')[0]).toBe('40');
    expect(run.printed()).not.toContain('on\n');
    expect(run.ended()?.exception).toMatchObject({ type: 'NameError', line: 5 });
  });

  it('lets a callback sleep itself', () => {
    const program = `
n = 0
@run_every(ms=50)
def slow():
    global n
    sleep(80)
    n += 1
sleep(1000)
print(n > 8)`;
    expect(linesOf(program)).toEqual(['True']);
  });

  it('ends the program with the error of a callback, which except Exception does not catch', () => {
    const run = play(`
from microbit import *
@run_every(ms=20)
def tick():
    nothing
try:
    sleep(1000)
except Exception:
    print('caught')
print('on')`).until(3000);
    expect(run.ended()?.kind).toBe('exception');
    expect(run.ended()?.exception).toMatchObject({
      type: 'NameError',
      message: "name 'nothing' isn't defined",
      line: 5,
    });
    expect(run.printed()).not.toContain('on\n');
  });

  it('counts days: 25 of them have more milliseconds than 31 bits', () => {
    const run = play(`
from microbit import *
run_every(lambda: print('never today'), days=25)
run_every(lambda: print('a second'), days=-1, h=24, s=1)
run_every(lambda: print('never'), days=49)
run_every(lambda: print('too many for 32 bits'), days=49, h=17, min=2, s=48, ms=296)
sleep(1500)`).until(3000);
    expect(run.printed()).toBe('a second\ntoo many for 32 bits\n');
  });

  it('takes its periods by name only', () => {
    expect(linesOf("err(run_every, print, 5)\nerr(lambda: run_every(print, ms='a'))")).toEqual([
      'TypeError: extra positional arguments given',
      "TypeError: can't convert str to int",
    ]);
  });
});

describe('input', () => {
  it('asks, echoes and returns the line', () => {
    const run = play("name = input('Name? ')\nprint('Hallo', name)");
    expect(run.until(100).printed()).toBe('Name? ');
    run.vm.feed('Ada\r');
    expect(run.until(200).printed()).toBe('Name? Ada\nHallo Ada\n');
  });

  it('says that it waits, until the line has come', () => {
    const run = play("from microbit import sleep\nsleep(10)\nname = input('Name? ')\nsleep(1000)");
    expect(run.until(5).vm.awaitsInput).toBe(false);
    expect(run.until(100).vm.awaitsInput).toBe(true);
    run.vm.feed('Ad');
    expect(run.until(200).vm.awaitsInput).toBe(true);
    run.vm.feed('a\r');
    expect(run.until(300).vm.awaitsInput).toBe(false);
  });

  it('waits no more once it is interrupted', () => {
    const run = play('try:\n    input()\nexcept KeyboardInterrupt:\n    while True: pass').until(10);
    run.vm.interrupt();
    expect(run.until(20).vm.awaitsInput).toBe(false);
  });

  it('raises EOFError at Ctrl-D', () => {
    const run = play("try:\n    input()\nexcept EOFError:\n    print('end')").until(10);
    run.vm.feed('\x04');
    expect(run.until(100).printed()).toBe('end\n');
  });
});
