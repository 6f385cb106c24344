import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { runProgram } from './testing/run-program';

const read = (name: string): string => readFileSync(new URL(`./testing/${name}`, import.meta.url), 'utf8');

const programs = {
  recursion: `
def depth(n):
    return 1 + depth(n - 1) if n else 0
print(depth(100))
lowest = 100
try:
    while True:
        depth(lowest)
        lowest += 1
except RuntimeError as error:
    print(lowest, error)`,
  'try, finally and with': `
class Door:
    def __enter__(self): print("open")
    def __exit__(self, *args): print("shut", args[0])
def walk():
    for i in range(3):
        try:
            with Door():
                if i == 2: raise KeyError(i)
        finally:
            print("done", i)
try:
    walk()
except KeyError as error:
    print("caught", error)`,
  'generators and closures': `
def count(n):
    while n:
        got = yield n
        n -= 1
def adder(k):
    return lambda x: x + k
print([adder(i)(10) for i in count(20)], sum(x * x for x in range(50)))`,
  'sorting with a key': 'print(sorted(range(100), key=lambda x: (x * 37) % 101))',
  'strings, dicts and garbage': `
import gc
words = {}
for i in range(3000):
    words["w%d" % (i % 200)] = [i] * 5
print(len(words), sum(v[0] for v in words.values()), gc.mem_free())`,
  'exceptions in exceptions': `
def fail(n):
    try:
        if n == 0: raise ValueError("deep")
        fail(n - 1)
    except ValueError as error:
        raise OSError(n) from error
try:
    fail(10)
except OSError as error:
    print(error)`,
  'big integers and floats': `
n = 1
for i in range(1, 60): n *= i
print(n, n % 1000007, 2 ** 0.5, 1 / 3)`,
  'device calls': `
from microbit import *
import utime
start = utime.ticks_us()
for i in range(20):
    sleep(3)
    pin0.write_digital(i % 2)
    display.set_pixel(i % 5, 0, 9)
display.show("AB", delay=50)
print(utime.ticks_us() - start, running_time())`,
  callbacks: `
from microbit import *
ticks = 0
def tick():
    global ticks
    ticks += 1
run_every(tick, ms=100)
n = 0
while ticks < 5: n += 1
sleep(500)
print(ticks, n)`,
};

describe('a program that is suspended again and again', () => {
  for (const [what, program] of Object.entries(programs)) {
    const straight = runProgram(program);
    it.each([17, 485, 4000])(`${what}: prints the same when suspended every %i µs`, (sliceUs) => {
      const suspended = runProgram(program, { sliceUs });
      expect(suspended).toEqual(straight);
      expect(straight.ended?.kind).toBe('finished');
    });
  }

  it('is suspended at each single bytecode without a difference', () => {
    const program =
      'x = 0\nfor i in range(300):\n    try:\n        x += 1 // (i % 3)\n    except ZeroDivisionError:\n        x += 5\nprint(x)';
    expect(runProgram(program, { sliceUs: 1 })).toEqual(runProgram(program));
  });

  it.each([700, 20_000, Infinity])('goes as deep as ever, whatever is called, in slices of %i µs', (sliceUs) => {
    expect(runProgram(read('depth.py'), { sliceUs }).console).toBe(read('depth.txt'));
  });

  it('allows at least 100 nested calls and then raises RuntimeError', () => {
    const { console } = runProgram(programs.recursion);
    const [, limit] = console.split('\n');
    expect(console).toMatch(/^100\n/);
    expect(limit).toMatch(/^1\d\d maximum recursion depth exceeded$/);
  });
});
