import { computed } from 'vue';
import { describe, expect, it } from 'vitest';

import type { InputAction } from '#simulation/input';
import { RADIO_ENTRIES, RadioModel, readable } from './radio-model';

function model() {
  const sent: InputAction[] = [];
  const run = { input: (action: InputAction) => sent.push(action) > 0, nowUs: computed(() => 2_000_000) };
  return { radio: new RadioModel(run), sent };
}
const packet = (text: string, timeUs = 0) => ({
  timeUs,
  group: 0,
  bytes: [1, 0, 1, ...new TextEncoder().encode(text)],
});

describe('a radio packet', () => {
  it('is read as text when it begins with 1, 0, 1 as radio.send writes it', () => {
    expect(readable(packet('Grüezi 👋').bytes)).toEqual({ text: 'Grüezi 👋', isText: true });
    expect(readable([1, 0, 1])).toEqual({ text: '', isText: true });
  });

  it('is read as bytes otherwise, also when its text is none', () => {
    expect(readable([0, 255, 10])).toEqual({ text: '00 ff 0a', isText: false });
    expect(readable([1, 0, 1, 0xff])).toEqual({ text: '01 00 01 ff', isText: false });
  });
});

describe('the list of radio packets', () => {
  it('shows what the program sent and what was sent to it, with their times', () => {
    const { radio, sent } = model();
    radio.take([packet('a', 1_000_000)], 0);
    radio.send('b');
    expect(radio.entries.value.map(({ text, from, timeUs }) => [text, from, timeUs])).toEqual([
      ['a', 'program', 1_000_000],
      ['b', 'hand', 2_000_000],
    ]);
    expect(sent).toEqual([{ type: 'radio', text: 'b' }]);
  });

  it('keeps the newest 200 of 10 000 packets and says that others are left out', () => {
    const { radio } = model();
    for (let i = 0; i < 100; i += 1)
      radio.take(
        Array.from({ length: 100 }, (_, n) => packet(`${i * 100 + n}`)),
        0,
      );
    expect(radio.entries.value).toHaveLength(RADIO_ENTRIES);
    expect(radio.entries.value.at(-1)?.text).toBe('9999');
    expect(radio.isCut.value).toBe(true);
    radio.clear();
    expect([radio.entries.value, radio.isCut.value]).toEqual([[], false]);
  });

  it('says that packets are left out when the program sent more than the page was told', () => {
    const { radio } = model();
    radio.take([packet('a')], 7);
    expect(radio.isCut.value).toBe(true);
  });

  it('marks a text that was sent while the radio of the program was off, and no other', () => {
    const { radio } = model();
    radio.send('a', false);
    radio.send('b', true);
    expect(radio.entries.value.map(({ text, isLost }) => [text, isLost ?? false])).toEqual([
      ['a', true],
      ['b', false],
    ]);
  });
});
