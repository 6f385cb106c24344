import { describe, expect, it } from 'vitest';

import { createOutbox, type Output } from './outbox';

function outbox() {
  const sent: (readonly Output[])[] = [];
  const box = createOutbox((output) => sent.push(output));
  const put = (text: string, device = 0, timeUs = 0): void => box.put([{ device, text, timeUs }]);
  const texts = (): string[] => sent.map((batch) => batch.map(({ text }) => text).join(''));
  return { sent, box, put, texts };
}

describe('the console outbox', () => {
  it('sends the first text at once and the rest only when the page has taken it', () => {
    const { box, put, texts } = outbox();
    put('a');
    put('b');
    put('c');
    expect(texts()).toEqual(['a']);
    box.taken();
    expect(texts()).toEqual(['a', 'bc']);
  });

  it('sends at most 32,768 characters at a time', () => {
    const { box, put, texts } = outbox();
    put('x'.repeat(40_000));
    box.taken();
    expect(texts().map((text) => text.length)).toEqual([32_768, 7232]);
  });

  it('is full at 115,200 waiting characters, so that the program waits', () => {
    const { box, put } = outbox();
    put('a');
    put('x'.repeat(115_199));
    expect(box.isFull).toBe(false);
    put('x');
    expect(box.isFull).toBe(true);
    box.taken();
    expect(box.isFull).toBe(false);
  });

  it('sends what was printed together as one, of several devices too', () => {
    const { box, sent } = outbox();
    box.put([{ device: 0, text: 'a', timeUs: 0 }, { device: 0, text: 'b', timeUs: 1 }, { device: 1, text: 'c', timeUs: 2 }]); // prettier-ignore
    expect(sent).toEqual([[{ device: 0, text: 'ab', timeUs: 0 }, { device: 1, text: 'c', timeUs: 2 }]]); // prettier-ignore
  });

  it('loses nothing at the end of a run', () => {
    const { box, put, texts } = outbox();
    put('a');
    put('b');
    box.flush();
    expect(texts().join('')).toBe('ab');
    expect(box.isEmpty).toBe(true);
  });

  it('keeps the order in which several devices print, each piece with its device and the time of its beginning', () => {
    const { sent, box, put } = outbox();
    put('first');
    put('a', 0, 10);
    put('b', 0, 20);
    put('c', 1, 30);
    put('d'.repeat(40_000), 0, 40);
    box.taken();
    expect(sent[1]?.map(({ device, timeUs }) => [device, timeUs])).toEqual([[0, 10], [1, 30], [0, 40]]); // prettier-ignore
    box.taken();
    expect(sent[2]).toEqual([{ device: 0, timeUs: 40, text: 'd'.repeat(40_000 - 32_765) }]);
  });
});
