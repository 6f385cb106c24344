import { describe, expect, it } from 'vitest';
import type { Bench } from '#board/testing/bench';
import { linesOf, play } from './testing/play';

const DARK = '.....\n.....\n.....\n.....\n.....';

/** Presses and lets go at these ms after the start. */
function pressing(ms: number, id: string) {
  return ({ clock, board }: Bench): void => {
    clock.at(ms * 1000, () => board.sensors.set(id, 1));
    clock.at((ms + 100) * 1000, () => board.sensors.set(id, 0));
  };
}

describe('power', () => {
  it('sleeps for a time, the LEDs dark', () => {
    const run = play(`
from microbit import *
import power
display.show(Image.HEART)
power.deep_sleep(2000)
print(running_time())`);
    run.until(1000);
    expect([run.bench.board.power.state, run.bench.picture()]).toEqual(['asleep', DARK]);
    run.until(2100);
    expect([run.bench.board.power.state, run.printed()]).toEqual(['on', '2000\n']);
    expect(run.bench.picture()).not.toBe(DARK);
  });

  it.each([
    ['button_a', 'buttonA'],
    ['(pin0, button_b)', 'buttonB'],
    ['[button_a, pin0]', 'pin0'],
    ['pin_logo', 'pinLogo'],
  ])('wakes on %s when %s is pressed at 700 ms', (source, id) => {
    const program = `
import power
power.deep_sleep(wake_on=${source})
t = running_time()
power.deep_sleep(ms=5000, wake_on=button_b)
print(t, running_time() - t)`;
    const [t, rest] = linesOf(program, {}, pressing(700, id))[0]!.split(' ').map(Number);
    expect(t).toBe(700);
    // A button that is still held does not let the board fall asleep.
    expect(rest).toBe(id === 'buttonB' ? 0 : 5000);
  });

  it('wakes when a wire changes', () => {
    const setUp = ({ clock, chip }: Bench): void => {
      const end = chip('P1');
      clock.at(300_000, () => end.drive(1));
    };
    const program = 'import power\npower.deep_sleep(wake_on=pin1)\nprint(running_time())';
    expect(linesOf(program, {}, setUp)).toEqual(['300']);
  });

  it('is silent asleep', () => {
    const run = play('import music, power\nmusic.pitch(440, wait=False)\npower.deep_sleep(1000)');
    run.until(500);
    expect(run.bench.board.music.frequencyHz).toBeNull();
  });

  it.each(['', 'run_every=False', 'wake_on=()'])(
    'sleeps without a source until a byte comes from the computer: %s',
    (given) => {
      const run = play(`from microbit import *\nimport power\npower.deep_sleep(${given})\nprint(running_time())`);
      run.until(60_000).vm.feed('x');
      expect(run.until(61_000).printed()).toBe('60000\n');
    },
  );

  it('runs what is due in between, unless told not to', () => {
    const program = (runs: string): string => `
import power
ran = []
run_every(lambda: ran.append(running_time() // 100), ms=300)
power.deep_sleep(1000, run_every=${runs})
print(running_time(), ran)`;
    expect(linesOf(program('True'))).toEqual(['1000 [3, 6, 9]']);
    expect(linesOf(program('False'))).toEqual(['1000 []']);
  });

  it('refuses what cannot wake it', () => {
    const program = `
import power
err(power.deep_sleep, '5')
err(power.deep_sleep, 5, 7)
err(power.deep_sleep, 5, (button_a, display))`;
    expect(linesOf(program)).toEqual([
      "TypeError: can't convert str to int",
      'ValueError: expecting a pin or button',
      'ValueError: expecting a pin or button',
    ]);
  });

  it('does nothing while it is off: no callback, no radio, no sound', () => {
    const run = play(`
from microbit import *
import music, power, radio
run_every(lambda: print('tick'), ms=100)
music.pitch(440, wait=False)
sleep(150)
power.off()`);
    run.until(10_000);
    const { board } = run.bench;
    expect([run.printed(), board.radio.isOn, board.music.frequencyHz]).toEqual(['tick\n', false, null]);
  });

  it('stays off: nothing of the program runs any more', () => {
    const run = play(`
from microbit import *
import power
display.show(Image.HEART)
print('bye')
power.off()
print('never')`);
    run.until(100).vm.interrupt();
    run.until(600_000);
    expect([run.printed(), run.ended(), run.bench.board.power.state, run.bench.picture()]).toEqual([
      'bye\n',
      null,
      'off',
      DARK,
    ]);
  });
});
