import { expect, it } from 'vitest';

import type { RadioEntry } from '../../../session/run/radio-model';
import { newestPackets } from './newest-packets';

const packet = (id: number, ms: number, device: number, from: RadioEntry['from'] = 'program'): RadioEntry => ({
  ...{ id, timeUs: ms * 1000, device, from, text: `n${String(id)}`, isText: true },
});

it('shows the last packet of each program for 0.8 s; those by hand are not shown', () => {
  const entries = [
    packet(1, 100, 0),
    packet(2, 900, 0),
    packet(3, 950, 0, 'hand'),
    packet(4, 1000, 1),
    packet(5, 1100, 0),
  ];
  const seen = (ms: number) => newestPackets(entries, ms * 1000).map(({ id }) => id);
  expect(seen(1200)).toEqual([4, 5]);
  expect(seen(1801)).toEqual([5]);
  expect(seen(1901)).toEqual([]);
});
