import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

describe('pins in Python', () => {
  it('have the classes of the device', () => {
    expect(linesOf('print(pin0, pin3, pin5, pin_logo, button_a)')).toEqual([
      '<MicroBitTouchPin> <MicroBitAnalogDigitalPin> <MicroBitDigitalPin> <MicroBitTouchOnlyPin> <MicroBitButton>',
    ]);
  });

  it('read, pull and change their mode', () => {
    const program = `
print(pin0.read_digital(), pin0.get_mode(), pin0.get_pull())
pin0.set_pull(pin0.PULL_UP)
print(pin0.read_digital(), pin0.get_pull())
pin0.write_digital(1)
print(pin0.get_mode())
err(pin0.get_pull)`;
    expect(linesOf(program)).toEqual([
      '0 read_digital 0', // the device tells PULL_UP until a pull is set: board/SPEC.md G6
      '1 0',
      'write_digital',
      'ValueError: Pin 0 in write_digital mode',
    ]);
  });

  it('refuse levels that are none in the words of the device', () => {
    const program = `
for value in (2, -1, '1', 1.0, None):
    err(pin0.write_digital, value)
pin0.write_digital(True)`;
    expect(linesOf(program)).toEqual([
      'ValueError: value must be 0 or 1',
      'ValueError: value must be 0 or 1',
      "TypeError: can't convert str to int",
      "TypeError: can't convert float to int",
      "TypeError: can't convert NoneType to int",
    ]);
  });

  it('say who holds them', () => {
    const program = `
err(pin3.write_digital, 1)
err(pin3.read_analog)
err(pin5.write_digital, 1)
print(pin5.read_digital(), pin5.get_mode())
err(pin19.read_digital)
err(pin20.write_analog, 3)`;
    expect(linesOf(program)).toEqual([
      'ValueError: Pin 3 in display mode',
      'ValueError: Pin 3 in display mode',
      'ValueError: Pin 5 in button mode',
      '1 button',
      'ValueError: Pin 19 in i2c mode',
      'ValueError: Pin 20 in i2c mode',
    ]);
  });

  it('write analog with a shared period, which one beyond the hardware leaves as it was, without a word', () => {
    const program = `
pin0.write_analog(512)
pin1.write_analog(100)
print(pin0.get_mode(), pin0.get_analog_period_microseconds())
pin0.set_analog_period(10)
print(pin1.get_analog_period_microseconds())
for ms in 0, 263, 1000, -1:
    pin0.set_analog_period(ms)
pin0.set_analog_period_microseconds(262144)
print(pin1.get_analog_period_microseconds())
err(pin0.write_analog, 1024)
err(pin0.write_analog, -1)
err(pin0.write_analog, 1023.6)
err(pin0.write_analog, 'a')
err(pin0.write_analog, 2**40)
err(pin0.write_digital, 2**40)
err(pin0.write_digital, 2**32 + 1)
pin0.write_analog(0)
print(pin0.get_mode(), pin2.get_analog_period_microseconds())`;
    expect(linesOf(program)).toEqual([
      'write_analog 20000',
      '10000',
      '10000',
      'ValueError: value must be between 0 and 1023',
      'ValueError: value must be between 0 and 1023',
      'ValueError: value must be between 0 and 1023',
      "TypeError: can't convert str to int",
      ...Array.from({ length: 3 }, () => 'OverflowError: overflow converting long int to machine word'),
      'unused -1',
    ]);
  });

  it('read a voltage of half the supply as 512', () => {
    expect(linesOf('print(pin2.read_analog())', {}, (bench) => bench.chip('P2').driveAnalog(0.5))).toEqual(['512']);
  });

  it('lack what the device lacks: pin8 has no read_analog, the logo no read_digital', () => {
    expect(linesOf('err(lambda: pin8.read_analog())\nerr(lambda: pin_logo.read_digital())')).toEqual([
      "AttributeError: 'MicroBitDigitalPin' object has no attribute 'read_analog'",
      "AttributeError: 'MicroBitTouchOnlyPin' object has no attribute 'read_digital'",
    ]);
  });
});

describe('buttons and touch in Python', () => {
  it('count a press of A and a touch of the logo while the program waits', () => {
    const run = play(`
from microbit import *
sleep(200)
print(button_a.was_pressed(), button_a.get_presses(), button_b.get_presses(), pin_logo.is_touched())
print(button_a.was_pressed(), button_a.get_presses())`);
    run.until(10).bench.board.buttonA.press();
    run.bench.board.touch.get('pin_logo')?.press();
    run.until(100).bench.board.buttonA.release();
    expect(run.until(1000).printed()).toBe('True 1 0 True\nFalse 0\n');
  });

  it('see a press at 100 ms after exactly 36 ms and a release at 300 ms after exactly 44 ms', () => {
    const run = play(`
from microbit import *
while not button_a.is_pressed():
    pass
print(running_time())
while button_a.is_pressed():
    pass
print(running_time(), button_a.get_presses())`);
    run.until(100).bench.board.buttonA.press();
    run.until(300).bench.board.buttonA.release();
    expect(run.until(500).printed()).toBe('136\n344 1\n');
  });

  it('see a touch of pin 1 as late as a press, and neither when it lasts 30 ms', () => {
    const run = play(`
from microbit import *
pin1.is_touched()
while not pin1.is_touched():
    pass
print(running_time(), button_b.was_pressed())`);
    const pad = run.bench.board.touch.get('pin1');
    run.until(20);
    pad?.press();
    run.bench.board.buttonB.press();
    run.until(50);
    pad?.release();
    run.bench.board.buttonB.release();
    run.until(200);
    pad?.press();
    expect(run.until(500).printed()).toBe('236 False\n');
  });

  it('sense a finger in another way when told, and refuse on a held pin', () => {
    const program = `
pin0.set_touch_mode(pin0.CAPACITIVE)
print(pin0.get_mode(), pin_logo.CAPACITIVE, pin_logo.RESISTIVE)
pin0.write_analog(3)
print(pin0.is_touched(), pin0.get_mode())
import music
music.play(music.ENTERTAINER, pin=pin0, wait=False)
err(pin0.is_touched)
err(pin0.set_touch_mode, 0)`;
    expect(linesOf(program)).toEqual([
      'touch 1 0',
      'False touch',
      'ValueError: Pin 0 in music mode',
      'ValueError: Pin 0 in music mode',
    ]);
  });
});
