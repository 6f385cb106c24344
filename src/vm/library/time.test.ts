import { describe, expect, it } from 'vitest';
import { linesOf } from './testing/play';

describe('time', () => {
  it('sleeps on the simulated clock, in three units', () => {
    const program = `
import time, utime
print(time is utime, took(time.sleep, 0.01), took(time.sleep_ms, 20), took(time.sleep_us, 3000), took(time.sleep, 1), took(sleep, 10.9), took(sleep, -5))`;
    expect(linesOf(program)).toEqual(['True 10 20 3 1000 10 0']);
  });

  it('wraps ticks at 2³⁰', () => {
    expect(linesOf('import time\nprint(time.ticks_add(0x3fffffff, 1), time.ticks_diff(0, 0x3fffffff))')).toEqual([
      '0 1',
    ]);
  });

  it('counts microseconds and milliseconds alike, and has no names but those of the device', () => {
    const program = `
import time
sleep(1234)
print(time.ticks_ms(), time.ticks_us() // 1000, running_time())
print(' '.join(sorted(name for name in dir(time) if name[0] != '_')))`;
    expect(linesOf(program)).toEqual([
      '1234 1234 1234',
      'sleep sleep_ms sleep_us ticks_add ticks_diff ticks_ms ticks_us',
    ]);
  });

  it('refuses what is no number', () => {
    const program = `
import time
err(sleep, '5')
err(sleep, None)
err(sleep, 2**31)
err(sleep, 2**40)
err(sleep, float('nan'))
err(sleep, float('-inf'))
err(time.sleep, 'a')
err(time.sleep_ms, 1.5)
err(time.sleep_us, None)`;
    expect(linesOf(program)).toEqual([
      "TypeError: can't convert str to float",
      "TypeError: can't convert NoneType to float",
      'OverflowError: overflow converting long int to machine word',
      'OverflowError: overflow converting long int to machine word',
      'no error: None',
      'no error: None',
      "TypeError: can't convert str to float",
      "TypeError: can't convert float to int",
      "TypeError: can't convert NoneType to int",
    ]);
  });
});

describe('machine', () => {
  it('measures a pulse of 583 µs exactly and knows both time-outs; the level is any truth value', () => {
    const program = `
import machine
print(machine.time_pulse_us(pin1, 1))
print(machine.time_pulse_us(pin1, 1, 2000), machine.time_pulse_us(pin1, 0, 2000))
err(machine.time_pulse_us, 5, 1)
print([machine.time_pulse_us(pin1, level, 9) for level in (True, 5, 'high', 1.0, None, '', 0)])
err(machine.time_pulse_us, pin1, 1, 'a')
print(machine.freq(), len(machine.unique_id()))
machine.enable_irq(machine.disable_irq())
err(lambda: machine.mem32[0])`;
    const lines = linesOf(program, {}, (bench) => {
      const chip = bench.chip('P1');
      chip.drive(0);
      bench.clock.at(3000, () => chip.drive(1));
      bench.clock.at(3583, () => chip.drive(0));
    });
    expect(lines).toEqual([
      '583',
      '-2 -1',
      'TypeError: expecting a pin',
      '[-2, -2, -2, -2, -1, -1, -1]',
      "TypeError: can't convert str to int",
      '64000000 8',
      'NotImplementedError: reading machine.mem32[0x00000000] is not simulated',
    ]);
  });
});

describe('random', () => {
  it('gives the same numbers for the same seed of the run', () => {
    const program = 'import random\nprint(random.randint(1, 1000000), random.random())';
    expect(linesOf(program)).toEqual(linesOf(program));
  });
});
