import { describe, expect, it } from 'vitest';

import { momentOf, type Moment } from './moment';
import { recordedSound } from './testing/recorded-sound';
import { seen, type Changes } from './testing/drive';
import { createTonePlayer } from './tone-player';
import { silence, tonesOf } from './tones';
import { watchStill } from './watch-still';

function moment(changes: Changes, atMs = 0): Moment {
  const made = momentOf(seen(changes), atMs);
  if (made === null) throw new Error('There is no robot.');
  return made;
}
const beat = (aheadMm: number | null | undefined) => tonesOf(moment({ aheadMm })).beat;
const line = (...sensors: readonly (0 | 1)[]) => tonesOf(moment({ line: sensors })).line;

describe('the tones of a moment', () => {
  it('beep the faster and the higher, the nearer something is ahead: from once a second to eight times', () => {
    expect([500, 275, 50].map(beat)).toEqual([
      { everyMs: 1000, hz: 700 },
      { everyMs: 560, hz: 1050 },
      { everyMs: 120, hz: 1400 },
    ]);
    expect(beat(20)).toEqual(beat(50));
  });

  it('are silent where nothing is ahead within 50 cm, or the robot has no such sensor', () => {
    expect([510, null, undefined].map(beat)).toEqual([null, null, null]);
  });

  it('sound on the side of the sensor that is on the line, deeper at the left', () => {
    expect(line(1, 0)).toEqual({ hz: 262, pan: -1 });
    expect(line(0, 1)).toEqual({ hz: 392, pan: 1 });
    expect(line(1, 1)).toEqual({ hz: 327, pan: 0 });
    expect(line(0, 0)).toBeNull();
  });

  it('go over in steps where there are five sensors', () => {
    const pans = [line(1, 0, 0, 0, 0), line(0, 1, 1, 0, 0), line(0, 0, 1, 0, 0), line(0, 0, 0, 0, 1)];
    expect(pans.map((one) => one?.pan)).toEqual([-1, -0.25, 0, 1]);
  });
});

describe('what the tones make of the sound system', () => {
  it('is a beep each time one is due', () => {
    const { output, heard, pass } = recordedSound();
    const player = createTonePlayer(() => output);
    for (let i = 0; i < 26; i += 1) {
      player.play({ beat: { everyMs: 500, hz: 900 }, line: null }, 40 * i);
      pass(0.04);
    }
    expect(heard).toEqual(['beep 900', 'beep 900']);
  });

  it('is one tone that changes as long as a line is there, and ends with it', () => {
    const { output, heard } = recordedSound();
    const player = createTonePlayer(() => output);
    player.play({ beat: null, line: { hz: 262, pan: -1 } }, 0);
    player.play({ beat: null, line: { hz: 392, pan: 1 } }, 40);
    player.play(silence, 80);
    expect(heard).toEqual(['line 262', 'pan -1', 'line 392', 'pan 1', 'line ends']);
  });

  it('is left asleep while there is nothing to hear, and asked for twice a second at most', () => {
    let asked = 0;
    const player = createTonePlayer(() => {
      asked += 1;
      return null;
    });
    for (let ms = 0; ms < 1000; ms += 40) player.play(silence, ms);
    expect(asked).toBe(0);
    for (let ms = 0; ms < 1000; ms += 40) player.play({ beat: { everyMs: 100, hz: 900 }, line: null }, ms);
    expect(asked).toBe(2);
  });
});

describe('a robot that stands', () => {
  it('falls silent after three seconds, until it moves or sees something else', () => {
    const isStill = watchStill();
    expect([0, 2900, 3000].map((ms) => isStill(moment({ aheadMm: 90 }, ms)))).toEqual([false, false, true]);
    expect(isStill(moment({ aheadMm: 120 }, 3100))).toBe(false);
    expect(isStill(moment({ aheadMm: 120, xMm: 230 }, 6200))).toBe(false);
  });
});
