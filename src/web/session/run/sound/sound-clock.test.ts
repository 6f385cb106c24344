import { describe, expect, it } from 'vitest';
import { createSoundClock } from './sound-clock';

/** Times in s, rounded to 0.1 ms. */
const round = (s: number): number => Math.round(s * 10_000) / 10_000;

describe('clock of the sound', () => {
  it('plays the first sound 80 ms later and keeps the distances of simulated time', () => {
    const clock = createSoundClock();
    expect(round(clock.at(5_000_000, 1, 1))).toBe(1.08);
    expect(round(clock.at(5_120_000, 1.13, 1))).toBe(1.2);
    expect(round(clock.at(5_125_500, 1.13, 1))).toBe(1.2055);
  });

  it('ties anew after a pause, in which the wall clock went on and the run did not', () => {
    const clock = createSoundClock();
    clock.at(1_000_000, 1, 1);
    expect(round(clock.at(1_010_000, 9, 1))).toBe(9.08);
    expect(round(clock.at(1_020_000, 9, 1))).toBe(9.09);
  });

  it('ties anew when the sound system stood still while the run went on', () => {
    const clock = createSoundClock();
    clock.at(1_000_000, 1, 1);
    expect(round(clock.at(8_000_000, 1, 1))).toBe(1.08);
  });

  it('plays at once what is up to 20 ms late', () => {
    const clock = createSoundClock();
    clock.at(0, 1, 1);
    expect(clock.at(20_000, 1.11, 1)).toBe(1.11);
  });

  it('stretches time at half speed', () => {
    const clock = createSoundClock();
    clock.at(0, 1, 0.5);
    expect(round(clock.at(100_000, 1.1, 0.5))).toBe(1.28);
    expect(round(clock.at(110_000, 1.1, 1))).toBe(1.18);
  });
});
