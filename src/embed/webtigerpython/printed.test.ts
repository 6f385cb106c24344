import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';

import { KEPT_CHARACTERS, Printed } from './printed';

const traceback =
  'Traceback (most recent call last):\n  File "main.py", line 2, in <module>\nZeroDivisionError: divide by zero\n';
const serial = traceback.replaceAll('\n', '\r\n');

describe('what a program prints', () => {
  it('comes at once, with plain line ends', () => {
    const printed = new Printed();
    expect(printed.add('1\r\n2\r\n')).toBe('1\n2\n');
    expect(printed.add('3\r')).toBe('3');
    expect(printed.add('\n4')).toBe('\n4');
    expect(printed.end(null)).toBe('');
    expect(printed.whole).toBe('1\n2\n3\n4');
  });

  it('has the traceback that ends it kept apart, also behind a line that was not ended', () => {
    const printed = new Printed();
    expect(printed.add(`1\r\nx${serial}`)).toBe('1\nx');
    expect(printed.end(serial)).toBe('');
    expect(printed.whole).toBe(`1\nx${traceback}`);
  });

  it('keeps it apart wherever the pieces end', () => {
    for (let seed = 1; seed <= 300; seed += 1) {
      const rng = createRng(seed);
      const printed = new Printed();
      const text = `Trace\r\nTraceback is a word\r\n${seed % 2 === 0 ? serial : ''}on\r\n${serial}`;
      let out = '';
      for (let at = 0; at < text.length;) {
        const to = at + 1 + Math.floor(rng.unit() * 30);
        out += printed.add(text.slice(at, to));
        at = to;
      }
      out += printed.end(serial);
      expect(out, `seed ${String(seed)}`).toBe(`Trace\nTraceback is a word\n${seed % 2 === 0 ? traceback : ''}on\n`);
      expect(printed.whole).toBe(out + traceback);
    }
  });

  it('keeps a message of several lines with its traceback', () => {
    const long = `${serial.trimEnd()}\r\nsecond line\r\n`;
    const printed = new Printed();
    expect(printed.add(serial.trimEnd())).toBe('');
    const out = printed.add('\r\nsecond line\r\n') + printed.end(long);
    expect(out + long.replaceAll('\r\n', '\n')).toContain('second line');
  });

  it('gives back a traceback that the program printed itself and went on', () => {
    const printed = new Printed();
    expect(printed.add(serial)).toBe('');
    expect(printed.add('on\r\n')).toBe(`${traceback}on\n`);
    expect(printed.add(serial)).toBe('');
    expect(printed.release()).toBe(traceback);
    expect(printed.release()).toBe('');
    expect(printed.add(serial)).toBe('');
    expect(printed.end(null)).toBe(traceback);
  });

  it('is never held back for long: what only begins like a traceback comes out', () => {
    const printed = new Printed();
    let out = printed.add('Traceback (most recent call last):\n');
    expect(out).toBe('');
    for (let count = 0; count < 10_000; count += 1) out += printed.add('  line after line\n');
    expect(out.length).toBeGreaterThan(100_000);
  });

  it('is kept to its last part when it is very long', () => {
    const printed = new Printed();
    for (let count = 0; count < 60; count += 1) printed.add('x'.repeat(10_000));
    printed.add('the end');
    expect(printed.whole).toHaveLength(KEPT_CHARACTERS);
    expect(printed.whole.endsWith('xthe end')).toBe(true);
  });
});
