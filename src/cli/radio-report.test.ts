import { describe, expect, it } from 'vitest';
import { RadioKeeper } from './radio-report';
import { nothingYet } from './supervise';
import { RadioReport } from './with-radio';

const packet = (timeUs: number, bytes: readonly number[]) => ({ timeUs, bytes });
const long = Array.from({ length: 248 }, () => 0x78);

describe('the packets of a run in its report', () => {
  it('are texts, or bytes of two signs each', () => {
    const keeper = new RadioKeeper();
    keeper.add(packet(1500, [1, 0, 1, 0x67, 0x6f]));
    keeper.add(packet(2000, [0, 255, 16]));
    expect(keeper.take()).toEqual({
      packets: [
        { atMs: 1.5, text: 'go' },
        { atMs: 2, hex: '00ff10' },
      ],
      count: 2,
    });
  });

  it('are the first 250,000 bytes of a device; all are counted', () => {
    const keeper = new RadioKeeper();
    for (let index = 0; index < 20_000; index += 1) keeper.add(packet(index, long));
    const { packets, count } = keeper.take();
    expect([packets.length, count]).toEqual([1008, 20_000]);
    for (let index = 0; index < 20_000; index += 1) keeper.add(packet(index, []));
    expect([keeper.take().packets.length, keeper.take().count]).toEqual([10_000 - 1008, 40_000]);
  });

  it('are told once, as they come, and put together', () => {
    const told = new RadioReport();
    const [one, two] = [
      { atMs: 1, text: 'a' },
      { atMs: 2, text: 'b' },
    ];
    const none = { packets: [], count: 0 };
    told.add([{ packets: [one], count: 1 }, none]);
    told.add([{ packets: [two], count: 5 }, none]);
    expect(told.in(nothingYet)).toMatchObject({ radio: [one, two], radioSent: 5 });
  });
});
