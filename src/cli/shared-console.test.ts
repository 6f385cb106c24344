import { describe, expect, it } from 'vitest';
import { createConsoleReader, createConsoleWriter, createSharedConsole, type Said } from './shared-console';

const textOf = (said: readonly Said[]): string => said.map(({ text }) => text).join('');

describe('the shared console', () => {
  it('hands over every character in order, round and round the buffer', () => {
    const shared = createSharedConsole();
    const write = createConsoleWriter(shared);
    const read = createConsoleReader(shared);
    let sent = '';
    let received = '';
    for (let n = 0; n < 2_000; n++) {
      const text = `line ${n}: Grüezi 🤖 ${'x'.repeat(n % 97)}\n`;
      sent += text;
      write(text);
      if (n % 7 === 0) received += textOf(read());
    }
    received += textOf(read());
    expect(received).toBe(sent);
    expect(read()).toEqual([]);
  });

  it('goes on when its counters pass 2³²', () => {
    const shared = createSharedConsole();
    shared.counters.fill(-5);
    createConsoleWriter(shared)('0123456789');
    expect(textOf(createConsoleReader(shared)())).toBe('0123456789');
  });

  it('tells the devices apart, also in the middle of a character and where the buffer ends', () => {
    const shared = createSharedConsole();
    const write = createConsoleWriter(shared);
    const read = createConsoleReader(shared);
    const received = ['', '', ''];
    for (let n = 0; n < 3_000; n++) {
      write(`${n} Grüezi 🤖 `.repeat(1 + (n % 3)), n % 3);
      if (n % 11 === 0) for (const { device, text } of read()) received[device] = `${received[device] ?? ''}${text}`;
    }
    for (const { device, text } of read()) received[device] = `${received[device] ?? ''}${text}`;
    for (const device of [0, 1, 2]) {
      let expected = '';
      for (let n = device; n < 3_000; n += 3) expected += `${n} Grüezi 🤖 `.repeat(1 + (n % 3));
      expect(received[device]).toBe(expected);
    }
  });
});
