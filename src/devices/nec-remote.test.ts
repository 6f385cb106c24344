import { describe, expect, it } from 'vitest';
import { Clock } from '#core/clock';
import { attachNecDecoder, commandOf, FRAME_PERIOD_US, NecRemote, remoteKeys, type RemoteKey } from './nec-remote';

/** A remote control whose bursts and silences are written down, in µs. */
function bench() {
  const clock = new Clock();
  const remote = new NecRemote(clock);
  const edges: number[] = [];
  remote.onBurst(() => edges.push(clock.nowUs));
  return {
    clock,
    remote,
    decoder: attachNecDecoder(clock, remote),
    passMs: (ms: number) => clock.advanceTo(clock.nowUs + ms * 1000),
    pulses: () => edges.slice(1).map((edge, place) => edge - (edges[place] ?? 0)),
    press: (key: RemoteKey, ms: number) => {
      remote.set(key, true);
      clock.advanceTo(clock.nowUs + ms * 1000);
      remote.set(key, false);
    },
  };
}

/** The four bytes of a frame, lowest bit first. */
function bytesIn(pulses: readonly number[]): number[] {
  const bits = Array.from({ length: 32 }, (_, bit) => ((pulses[3 + 2 * bit] ?? 0) > 1000 ? 1 : 0));
  return [0, 8, 16, 24].map((from) =>
    bits.slice(from, from + 8).reduce<number>((byte, bit, at) => byte | (bit << at), 0),
  );
}

describe('The infrared remote control of the kit', () => {
  it('sends 9 ms, 4.5 ms, 32 bits and a last burst: address 00 BF, command, command inverted', () => {
    const { press, pulses } = bench();
    press('up', 100);
    expect(pulses().slice(0, 2)).toEqual([9000, 4500]);
    expect(pulses()).toHaveLength(2 + 64 + 1);
    expect(new Set(pulses().filter((_, at) => at >= 2 && at % 2 === 0))).toEqual(new Set([560]));
    expect(new Set(pulses().filter((_, at) => at >= 3 && at % 2 === 1))).toEqual(new Set([560, 1690]));
    expect(bytesIn(pulses())).toEqual([0x00, 0xbf, 10, 245]);
  });

  it('takes 67 ms for a frame, whichever key it is', () => {
    for (const [key] of remoteKeys) {
      const { press, pulses } = bench();
      press(key, 100);
      expect(pulses().reduce((sum, length) => sum + length, 0)).toBe(66_850);
      expect(bytesIn(pulses())[2]).toBe(commandOf(key));
    }
  });

  it('repeats every 110 ms while a key is held: 9 ms, 2.25 ms, 0.56 ms', () => {
    const { press, pulses, passMs } = bench();
    press('up', 250);
    passMs(500);
    const after = pulses().slice(67);
    expect(after).toEqual([FRAME_PERIOD_US - 66_850, 9000, 2250, 560, FRAME_PERIOD_US - 11_810, 9000, 2250, 560]);
  });

  it('sends a whole frame for the shortest tap, and for a second tap its own in the next period', () => {
    const { press, pulses, passMs } = bench();
    press('1', 1);
    press('2', 1);
    passMs(400);
    expect(pulses()).toHaveLength(67 + 1 + 67);
    expect([bytesIn(pulses())[2], bytesIn(pulses().slice(68))[2]]).toEqual([16, 17]);
  });

  it('keeps no alarm once it is silent', () => {
    const { press, clock, passMs } = bench();
    press('power', 50);
    passMs(200);
    expect(clock.alarms).toBe(0);
  });
});

describe('A chip that understands the frames', () => {
  it('gives key 1 as 00 FD 08 F7 while it is held, and 0 before and after', () => {
    const { remote, decoder, passMs } = bench();
    expect(decoder.code()).toBe(0);
    remote.set('1', true);
    passMs(66);
    expect(decoder.code()).toBe(0);
    passMs(1);
    expect(decoder.code()).toBe(0x00fd08f7);
    passMs(1000);
    expect(decoder.code()).toBe(0x00fd08f7);
    remote.set('1', false);
    passMs(250);
    expect(decoder.code()).toBe(0);
  });
});
