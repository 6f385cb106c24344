import { describe, expect, it } from 'vitest';

import { createOutbox } from './outbox';

function outbox() {
  const sent: string[] = [];
  return { sent, box: createOutbox((text) => sent.push(text)) };
}

describe('the console outbox', () => {
  it('sends the first text at once and the rest only when the page has taken it', () => {
    const { sent, box } = outbox();
    box.put('a');
    box.put('b');
    box.put('c');
    expect(sent).toEqual(['a']);
    box.taken();
    expect(sent).toEqual(['a', 'bc']);
  });

  it('sends at most 32,768 characters at a time', () => {
    const { sent, box } = outbox();
    box.put('x'.repeat(40_000));
    box.taken();
    expect(sent.map((text) => text.length)).toEqual([32_768, 7232]);
  });

  it('is full at 115,200 waiting characters, so that the program waits', () => {
    const { box } = outbox();
    box.put('a');
    box.put('x'.repeat(115_199));
    expect(box.isFull).toBe(false);
    box.put('x');
    expect(box.isFull).toBe(true);
    box.taken();
    expect(box.isFull).toBe(false);
  });

  it('loses nothing at the end of a run', () => {
    const { sent, box } = outbox();
    box.put('a');
    box.put('b');
    box.flush();
    expect(sent.join('')).toBe('ab');
    expect(box.isEmpty).toBe(true);
  });
});
