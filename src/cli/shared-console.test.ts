import { describe, expect, it } from 'vitest';
import { createConsoleReader, createConsoleWriter, createSharedConsole } from './shared-console';

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
      if (n % 7 === 0) received += read();
    }
    received += read();
    expect(received).toBe(sent);
    expect(read()).toBe('');
  });

  it('goes on when its counters pass 2³²', () => {
    const shared = createSharedConsole();
    shared.counters.fill(-5);
    createConsoleWriter(shared)('0123456789');
    expect(createConsoleReader(shared)()).toBe('0123456789');
  });
});
