import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { folder, file } = useFolder();
const lines = (...texts: string[]): string => texts.join('\n');

/** Runs a program on the bare board with the given inputs, and returns the report. */
function run(program: string, inputs: readonly object[], ...more: string[]) {
  const main = file('main.py', program);
  const input = file('input.json', JSON.stringify(inputs));
  const { out, err } = parcours('run', main, '--robot', 'none', '--input', input, '--json', '--quiet', ...more);
  return { ...lastLine(out), err };
}

describe('parcours run with the microcomputer alone', { timeout: 30_000 }, () => {
  it('lets buttons, touch pads and gestures reach the program', () => {
    const program = lines(
      'from microbit import *',
      'for i in range(50):',
      '    sleep(100)',
      '    if button_a.was_pressed(): print("a")',
      '    if button_b.was_pressed(): print("b")',
      '    if pin_logo.is_touched(): print("logo")',
      '    if accelerometer.was_gesture("shake"): print("shake")',
    );
    const report = run(program, [
      { at: '500ms', button: 'a', down: true },
      { at: '700ms', button: 'a', down: false },
      { at: '1s', touch: 'pinLogo', down: true },
      { at: '1100ms', touch: 'pinLogo', down: false },
      { at: '2s', sensor: 'gesture', value: 'shake' },
      { at: '3s', sensor: 'buttonB', value: 1 },
    ]);
    expect(report.console).toBe('a\nlogo\nshake\nb\n');
    expect(report.ended).toBe('finished');
  });

  it('passes radio both ways and reports what was sent', () => {
    const program = lines(
      'import radio',
      'from microbit import sleep',
      'radio.config(group=7)',
      'for i in range(30):',
      '    sleep(100)',
      '    got = radio.receive()',
      '    if got: radio.send(got + "!")',
    );
    const report = run(program, [{ at: '1s', radio: 'go' }]);
    expect(report.radio).toMatchObject([{ text: 'go!' }]);
    expect(report.radio[0]?.atMs).toBeGreaterThan(1000);
    expect(report.radio[0]?.atMs).toBeLessThan(1200);
  });

  it('answers at the REPL what is typed after the end of the program, and is silent when nothing is', () => {
    const program = 'speed = 40\nprint("end")';
    expect(run(program, [], '--for', '3s').console).toBe('end\n');
    const typed = run(program, [{ at: '1s', serial: 'speed + 2\r' }], '--for', '3s');
    expect(typed.console.replaceAll('\r', '')).toBe(
      lines(
        'end',
        'MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2 with nRF52833',
        'Type "help()" for more information.',
        '>>> speed + 2',
        '42',
        '>>> ',
      ),
    );
    expect(typed.ended).toBe('finished');
  });

  it('is interrupted by Ctrl-C and runs anew with Ctrl-D', () => {
    const report = run(
      'print("begin")\nwhile True: pass',
      [
        { at: '1s', serial: '\u0003' },
        { at: '2s', serial: '\u0004' },
      ],
      '--for',
      '3s',
    );
    expect(report.console.replaceAll('\r', '')).toMatch(
      /^begin\nTraceback[^]*KeyboardInterrupt: ?\n[^]*>>> \nMPY: soft reboot\nbegin\n$/,
    );
    expect(report.ended).toBe('time-limit');
  });

  it('writes the data log to a file', () => {
    const program = lines(
      'import log',
      'log.set_labels("light", "x", timestamp=log.MILLISECONDS)',
      'log.add(light=3, x=-4)',
    );
    const csv = join(folder, 'log.csv');
    expect(run(program, [], '--log', csv).ended).toBe('finished');
    expect(readFileSync(csv, 'utf8')).toMatch(/^Time \(milliseconds\),light,x\r\n\d+,3,-4\r\n$/);
  });

  it('knows the Calliope mini 3 by its module, or by its name', () => {
    const rgb = 'import neopixel\nfrom calliopemini import *\nprint(pin_RGB, pin3.is_touched())';
    expect(run(rgb, [{ at: '0s', touch: 'pin3', down: true }]).console).toMatch(/^<MicroBit\w+> (True|False)\n$/);
    const held = run('from microbit import *\npin18.read_digital()', [], '--board', 'calliope-mini-3');
    expect(held.exception).toMatchObject({ type: 'ValueError', message: 'Pin 18 in display mode' });
    expect(run('import calliopemini', [], '--board', 'microbit-v2').exception).toMatchObject({ type: 'ImportError' });
  });

  it('has newer names with the newest firmware alone', () => {
    const program = 'from microbit import *\ndisplay.rotate(90)\nprint("turned")';
    expect(run(program, []).exception).toMatchObject({ type: 'AttributeError' });
    expect(run(program, [], '--firmware', 'newest').console).toBe('turned\n');
  });

  it('ends when the program switches the board off', () => {
    const report = run('import power\nprint("off")\npower.off()\nprint("never")', []);
    expect(report).toMatchObject({ ended: 'finished', console: 'off\n' });
    expect(report.simulatedMs).toBeLessThan(10_000);
  });
});

describe('parcours run --strict', { timeout: 30_000 }, () => {
  const modern = file('modern.py', 'name = "Ada"\nprint(f"Hello {name}")\n');

  it('lists what the real board would not understand, runs nothing and exits with 1', () => {
    const { code, out, err } = parcours('run', modern, '--strict');
    expect({ code, out }).toEqual({ code: 1, out: '' });
    expect(err).toMatch(/^main\.py:2:7: The micro:bit V2 does not know f-strings/);
    expect(parcours('run', modern)).toMatchObject({ code: 0, out: 'Hello Ada\n' });
  });

  it('explains in German too, and says in JSON what is wrong', () => {
    const { code, out, err } = parcours('run', modern, '--strict', '--lang', 'de', '--json');
    expect(code).toBe(1);
    expect(err).toMatch(/f-Strings/);
    expect(lastLine(out)).toMatchObject({ ended: 'exception', exception: { type: 'NotOnDevice' }, console: '' });
  });

  it('runs a program that is fine', () => {
    const fine = file('fine.py', 'print("{}".format(3))\n');
    expect(parcours('run', fine, '--strict')).toEqual({ code: 0, out: '3\n', err: '' });
  });
});
